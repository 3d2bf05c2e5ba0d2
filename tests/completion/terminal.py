"""A shell in a pseudo-terminal, in which words are typed and the Tab key is pressed."""
import os
import pty
import re
import select
import signal
import time


class Terminal:
    def __init__(self, command, folder, environment):
        self.pid, self.fd = pty.fork()
        if self.pid == 0:
            os.chdir(folder)
            os.execvpe(command[0], command, {**os.environ, "TERM": "dumb", "COLUMNS": "1000", "LC_ALL": "C.UTF-8", **environment})
        self.text = ""

    def wait_for(self, pattern, seconds=20):
        end = time.monotonic() + seconds
        while not (found := re.search(pattern, self.text, re.S)):
            if time.monotonic() > end or not select.select([self.fd], [], [], seconds)[0]:
                raise TimeoutError(f"no {pattern!r} in {self.text!r}")
            try:
                self.text += os.read(self.fd, 65536).decode(errors="replace")
            except OSError:
                raise TimeoutError(f"the shell has ended: {self.text!r}") from None
        self.text = self.text[found.end():]
        return found

    def type(self, keys):
        os.write(self.fd, keys.encode())

    def run(self, command):
        """Runs a command that prints nothing, and waits for its end."""
        self.type(command + "; echo en''d\r")
        self.wait_for("\nend\r?\n")

    def arguments(self, line, tabs="\t"):
        """What the words of the line are, as the command gets them, once Tab has been pressed behind it."""
        self.type(line + tabs + "\x01show \x05\r")  # to the start, a word, to the end
        return self.wait_for("\x02(.*?)\x03").group(1).split("\x1f")[:-1]

    def close(self):
        os.kill(self.pid, signal.SIGKILL)
        os.close(self.fd)
        os.waitpid(self.pid, 0)


# `show WORDS...` prints the words between marks.
SHOW = r"""show() { printf '\002'; printf '%s\037' "$@"; printf '\003\n'; }"""
