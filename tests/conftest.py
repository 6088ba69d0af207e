"""Parallel workers leave each other the cores: linear algebra takes one thread in each.

Workers whose small matrix products use a thread for each core wait for one another, up to 30 times as long. The
variables are set before the workers start, since a plugin may load NumPy before any file of tests.
"""

import os


def pytest_configure(config):
    if config.getoption("numprocesses", None):
        for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
            os.environ.setdefault(name, "1")
