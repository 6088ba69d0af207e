"""The one writer: what stands at the name is kept, followed, written to or refused; never replaced by mistake."""

import os
import socket
import stat
import threading
from pathlib import Path

import pytest

from skydome.ground import writing
from skydome.ground.writing import appearing, require_place


def write(path, text="new"):
    with appearing(path) as beside:
        beside.write_text(text)


def mode_of(path):
    return stat.S_IMODE(path.stat().st_mode)


def test_a_pipe_is_written_to(tmp_path):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    read = []
    reader = threading.Thread(target=lambda: read.append(pipe.read_text()))
    reader.start()
    write(pipe)
    reader.join(10)
    assert read == ["new"]
    assert stat.S_ISFIFO(pipe.stat().st_mode)


def test_a_pipe_of_the_shell_is_written_to(tmp_path):
    """As `-o >(command)` gives it: a name whose real path is no file's."""
    if not os.path.isdir("/dev/fd"):
        pytest.skip("no /dev/fd here")
    out, into = os.pipe()
    write(f"/dev/fd/{into}")
    os.close(into)
    with open(out) as file:
        assert file.read() == "new"


def test_a_device_is_written_to_and_stays(tmp_path):
    """A node of our own, of the numbers of /dev/null."""
    node = tmp_path / "null"
    try:
        os.mknod(node, 0o666 | stat.S_IFCHR, os.makedev(1, 3))
    except (PermissionError, AttributeError):
        pytest.skip("only root makes devices")
    write(node)
    assert stat.S_ISCHR(node.stat().st_mode)
    assert [entry.name for entry in tmp_path.iterdir()] == ["null"]


def test_a_socket_is_refused(tmp_path):
    with socket.socket(socket.AF_UNIX) as made:
        made.bind(str(tmp_path / "socket"))
        with pytest.raises(OSError, match="must be a file, got the socket"):
            write(tmp_path / "socket")
    assert stat.S_ISSOCK((tmp_path / "socket").stat().st_mode)


def test_links_are_followed(tmp_path):
    (tmp_path / "deep").mkdir()
    (tmp_path / "link").symlink_to("deep/file")
    for text in ("one", "two"):  # a link to nothing yet, then to a file
        write(tmp_path / "link", text)
        assert (tmp_path / "deep/file").read_text() == text
        assert (tmp_path / "link").is_symlink()
    (tmp_path / "round").symlink_to("round")
    with pytest.raises(OSError, match="round"):
        write(tmp_path / "round")


@pytest.mark.parametrize("mode", [0o600, 0o640, 0o755])
def test_permissions_are_kept_from_the_first_byte_on(tmp_path, mode):
    path = tmp_path / "file"
    path.write_text("old")
    path.chmod(mode)
    with appearing(path) as beside:
        assert mode_of(beside) == mode
        beside.write_text("new")
    assert (mode_of(path), path.read_text()) == (mode, "new")


def test_a_new_file_has_the_usual_permissions(tmp_path):
    (tmp_path / "usual").touch()
    write(tmp_path / "file")
    assert mode_of(tmp_path / "file") == mode_of(tmp_path / "usual")


def test_a_read_only_file_is_refused(tmp_path):
    path = tmp_path / "file"
    path.write_text("old")
    path.chmod(0o444)
    with pytest.raises(PermissionError, match="must not be read-only"):
        write(path)
    assert path.read_text() == "old"


def test_names_up_to_the_file_systems_limit(tmp_path):
    most = os.pathconf(tmp_path, "PC_NAME_MAX")
    write(tmp_path / ("n" * most))
    with pytest.raises(OSError, match="File name too long"):
        write(tmp_path / ("n" * (most + 1)))
    assert [len(entry.name) for entry in tmp_path.iterdir()] == [most]


def test_nothing_is_left_and_the_old_file_stays_where_writing_fails(tmp_path, monkeypatch):
    path = tmp_path / "file"
    path.write_text("old")

    def full(handle):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(writing.os, "fsync", full)
    with pytest.raises(OSError, match="No space left"):
        write(path)
    assert path.read_text() == "old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["file"]


def test_the_disk_has_the_bytes_before_the_name_is_given(tmp_path, monkeypatch):
    done = []
    replace, fsync = os.replace, os.fsync
    monkeypatch.setattr(writing.os, "fsync", lambda handle: (done.append("disk"), fsync(handle)))
    monkeypatch.setattr(writing.os, "replace", lambda a, b: (done.append("name"), replace(a, b)))
    write(tmp_path / "file")
    assert done == ["disk", "name", "disk"]


def test_a_folder_and_a_file_do_not_stand_in_each_others_place(tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(NotADirectoryError, match="is a folder, got the file"):
        require_place(tmp_path / "file", folder=True)
    with pytest.raises(IsADirectoryError, match="must not be a folder"):
        require_place(tmp_path)


def test_an_interrupt_just_when_the_hidden_file_is_made_leaves_nothing(tmp_path, monkeypatch):
    opened = Path.open

    def interrupted(path, *arguments):
        opened(path, *arguments).close()
        raise KeyboardInterrupt

    monkeypatch.setattr(Path, "open", interrupted)
    with pytest.raises(KeyboardInterrupt), appearing(tmp_path / "sky.exr"):
        pass
    assert list(tmp_path.iterdir()) == []
