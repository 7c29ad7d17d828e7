"""Programs run apart from us: heard, limited, interrupted, measured, and never left behind."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from vitrail.base.stopping import forget_stop, stop_threads
from vitrail.engines.child import Finished, Limits, run_child

pytestmark = pytest.mark.slow

PYTHON = sys.executable


def python(code: str) -> list[str]:
    return [PYTHON, "-c", code]


def is_running(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return Path(f"/proc/{pid}/stat").read_text().split()[2] != "Z"


def test_lines_go_to_the_listener_and_the_rest_is_kept() -> None:
    heard: list[str] = []
    code = "import sys; print('answer'); sys.stderr.write('one\\ntwo\\rthree\\nlast')"
    finished = run_child(python(code), on_line=lambda line: (heard.append(line), line == "two")[1])
    assert heard == ["one", "two", "three", "last"]
    assert finished.said == "one\nthree\nlast"
    assert (finished.code, finished.stdout) == (0, "answer\n")


def test_much_output_on_both_streams_does_not_block() -> None:
    code = "import sys; sys.stdout.write('x' * 3_000_000); sys.stderr.write('y\\n' * 500_000)"
    finished = run_child(python(code), limits=Limits(wall_s=60))
    assert len(finished.stdout) == 3_000_000
    assert finished.said.count("y") == 200  # the last lines are kept


def test_the_exit_code_and_the_signal_are_told() -> None:
    assert run_child(python("raise SystemExit(7)")).ending() == "ended with exit code 7"
    crashed = run_child(python("import os; os.kill(os.getpid(), 11)"))
    assert crashed.code == -signal.SIGSEGV
    assert crashed.ending() == "was ended by SIGSEGV"


def test_time_that_is_up_ends_it(tmp_path: Path) -> None:
    finished = run_child(python("import time; time.sleep(60)"), limits=Limits(wall_s=0.5))
    assert finished.timed_out
    assert 0.5 <= finished.wall_s < 10
    assert "was stopped after" in finished.ending()


def test_time_counts_after_the_program_has_closed_its_stderr() -> None:
    code = "import os, time; os.close(2); time.sleep(60)"
    assert run_child(python(code), limits=Limits(wall_s=0.5)).timed_out


def test_memory_beyond_the_limit_is_refused() -> None:
    code = "import time; time.sleep(0.3); x = bytearray(1 << 30)"
    finished = run_child(python(code), limits=Limits(memory_bytes=600 << 20))
    assert finished.code == 1
    assert "MemoryError" in finished.said


def test_cpu_time_is_measured_and_sleep_is_not() -> None:
    busy = run_child(python("import time\nt = time.process_time()\nwhile time.process_time() < t + 0.5: pass"))
    idle = run_child(python("import time; time.sleep(0.5)"))
    assert 0.5 <= busy.cpu_s < 2
    assert idle.cpu_s < 0.4
    assert idle.wall_s >= 0.5


def test_nothing_of_its_group_survives() -> None:
    code = (
        "import subprocess, sys\n"
        "child = subprocess.Popen([sys.executable, '-c', 'import time; time.sleep(60)'], stderr=subprocess.DEVNULL)\n"
        "print(child.pid)"
    )
    finished = run_child(python(code))
    grandchild = int(finished.stdout)
    deadline = time.monotonic() + 5
    while is_running(grandchild) and time.monotonic() < deadline:
        time.sleep(0.01)
    assert not is_running(grandchild)


def test_another_thread_ends_it_by_the_event() -> None:
    stop = threading.Event()
    threading.Timer(0.3, stop.set).start()
    finished = run_child(python("import time; time.sleep(60)"), stop=stop)
    assert finished.interrupted
    assert finished.wall_s < 10


INTERRUPTED_RUN = """
import sys
from vitrail.engines.child import run_child
code = '''
import signal, sys, time
def finish(number, frame):
    print("wrote what was finished", flush=True)
    raise SystemExit(130)
signal.signal(signal.SIGINT, finish)
sys.stderr.write("started\\\\n"); sys.stderr.flush()
time.sleep(60)
'''
heard = lambda line: (print(line, flush=True), True)[1]
finished = run_child([sys.executable, "-c", code], on_line=heard)
print(finished.interrupted, finished.code, finished.stdout.strip())
"""


def test_ctrl_c_is_passed_on_so_that_finished_work_is_written() -> None:
    environment = {**os.environ, "PYTHONPATH": "compare"}
    caller = subprocess.Popen([PYTHON, "-c", INTERRUPTED_RUN], stdout=subprocess.PIPE, text=True, env=environment)
    assert caller.stdout is not None
    assert caller.stdout.readline() == "started\n"
    caller.send_signal(signal.SIGINT)
    assert caller.stdout.read() == "True 130 wrote what was finished\n"
    assert caller.wait() == 0


def test_a_program_that_is_not_there_is_an_os_error() -> None:
    with pytest.raises(OSError):
        run_child(["/nowhere/program"])


def test_the_memory_is_the_program_s_own_and_not_ours() -> None:
    ours = b"x" * (300 << 20)
    finished = run_child(["sleep", "0.1"])
    assert finished.peak_memory_bytes < 20 << 20, "what the caller has resident is charged to the program"
    hungry = run_child(python("import time; x = b'x' * (100 << 20); time.sleep(0.1)"))
    assert 100 << 20 < hungry.peak_memory_bytes < 150 << 20
    assert len(ours) == 300 << 20


def test_when_all_shall_stop_other_threads_end_what_they_run_and_start_nothing() -> None:
    def run() -> Finished | None:
        try:
            return run_child(python("import time; time.sleep(60)"))
        except KeyboardInterrupt:
            return None

    with ThreadPoolExecutor(1) as pool:
        running, waiting = pool.submit(run), pool.submit(run)
        time.sleep(0.5)
        stop_threads()
        try:
            first, second = running.result(20), waiting.result(20)
        finally:
            forget_stop()
    assert first is not None and first.interrupted and first.wall_s < 20
    assert second is None
    assert run_child(python("pass")).code == 0
