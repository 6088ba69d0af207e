"""Files that begin with a head which is known only when all the rest has been written."""

from typing import BinaryIO

STEP = 1 << 23
"""Bytes that move at a time."""


class HeadedFile:
    """An open file, for reading and writing, that keeps room for a head; where the true one is longer, the rest moves.

    >>> from io import BytesIO
    >>> file = BytesIO()
    >>> headed = HeadedFile(file, room=2)
    >>> headed.append(b"body")
    >>> headed.finish(b"head:")
    >>> file.getvalue()
    b'head:body'
    """

    def __init__(self, file: BinaryIO, room: int) -> None:
        self.file, self.room = file, room
        file.write(bytes(room))

    def append(self, part: bytes | memoryview) -> None:
        """More of the rest."""
        self.file.write(part)

    def finish(self, head: bytes) -> None:
        """The head takes its place."""
        self.move(len(head) - self.room)
        self.file.seek(0)
        self.file.write(head)

    def move(self, by: int) -> None:
        """The rest stands so many bytes later, or earlier."""
        end = self.file.seek(0, 2)
        starts = range(self.room, end, STEP) if by else range(0)
        for start in reversed(starts) if by > 0 else starts:
            self.file.seek(start)
            part = self.file.read(min(STEP, end - start))
            self.file.seek(start + by)
            self.file.write(part)
        self.file.truncate(end + by)
