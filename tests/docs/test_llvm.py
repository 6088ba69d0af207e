"""The search for a libLLVM in the benchmarks: the newest first, and no abort ends the one that asks."""

import importlib.util
import os
from pathlib import Path

import pytest

FILE = Path(__file__).parents[2] / "benchmarks" / "llvm.py"


@pytest.fixture
def llvm():
    spec = importlib.util.spec_from_file_location("llvm", FILE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_newest_of_each_version_comes_first(llvm):
    names = ["/a/libLLVM-14.so.1", "/a/libLLVM-16.so.1", "/a/libLLVM.so.19.1", "/a/libLLVM.so", "/b/libLLVM-21.so"]
    assert llvm.newest_first(names) == ["/b/libLLVM-21.so", "/a/libLLVM.so.19.1", "/a/libLLVM-16.so.1"]


def test_a_version_that_aborts_is_passed_over(llvm, monkeypatch):
    monkeypatch.delenv("DRJIT_LIBLLVM_PATH", raising=False)
    monkeypatch.setattr(llvm, "glob", lambda pattern: ["/a/libLLVM-16.so.1", "/a/libLLVM.so.19.1"])
    fails = "import os; '{}' in os.environ['DRJIT_LIBLLVM_PATH'] and os.abort()"
    monkeypatch.setattr(llvm, "TRIAL", fails.format("19"))
    assert llvm.llvm_library() == "/a/libLLVM-16.so.1"
    monkeypatch.setattr(llvm, "TRIAL", fails.format("libLLVM"))
    assert llvm.llvm_library() is None
    monkeypatch.setattr(llvm, "TRIAL", "pass")
    assert llvm.llvm_library() == "/a/libLLVM.so.19.1"
    monkeypatch.setenv("DRJIT_LIBLLVM_PATH", os.devnull)
    assert llvm.llvm_library() == os.devnull


def test_what_is_asked_for_is_the_newest(llvm):
    assert "newest" in llvm.NO_LLVM
    assert not llvm.runs_with("/no/such/libLLVM.so")
