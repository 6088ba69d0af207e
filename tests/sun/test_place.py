import pytest

from skydome.sun.place import Place


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((91.0, 0.0), r"latitude must lie in \[-90, 90\], got 91"),
        ((0.0, 180.5), r"longitude must lie in \[-180, 180\], got 180\.5"),
        ((float("nan"), 0.0), "latitude must lie in .*, got nan"),
        ((0.0, 0.0, 1e6), "altitude must lie in"),
    ],
)
def test_place_refuses(arguments, message):
    with pytest.raises(ValueError, match=message):
        Place(*arguments)


def test_parse():
    assert Place.parse("45.07,7.69") == Place(45.07, 7.69)
    assert Place.parse(" -45.07 , -7.69 , 240 ") == Place(-45.07, -7.69, 240.0)


@pytest.mark.parametrize("text", ["", "45", "45;7", "45,7,1,2", "45N,7E", "Turin"])
def test_parse_refuses(text):
    with pytest.raises(ValueError, match=r"place must read latitude,longitude\[,altitude\]"):
        Place.parse(text)


def test_parse_checks_ranges():
    with pytest.raises(ValueError, match="latitude must lie in"):
        Place.parse("91,0")
