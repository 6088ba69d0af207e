import warnings

import pytest


@pytest.fixture(scope="session")
def colour():
    """colour-science, the oracle; its warnings about optional packages are not ours."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return pytest.importorskip("colour")
