"""The destinations of a bag's bytes."""

from __future__ import annotations

import os
import zlib
from pathlib import Path

# Magic number, method "deflate", no flags, no time, no hints, unknown system.
_GZIP_HEADER = bytes([0x1F, 0x8B, 8, 0, 0, 0, 0, 0, 0, 0xFF])


class AppendFile:
    """A file that only grows: one `write` for each `append`. A failed `append` leaves the file unchanged."""

    def __init__(self, path: Path) -> None:
        """Creates or empties the file; its folders are created.

        Raises:
            OSError: The file cannot be created.
        """
        path.absolute().parent.mkdir(parents=True, exist_ok=True)
        self._file = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_TRUNC | getattr(os, "O_BINARY", 0), 0o666)
        self._is_torn = False
        self.length = 0
        """The number of bytes that were appended."""

    def append(self, data: bytes) -> None:
        """Raises OSError if not all bytes could be written; then none are, and the next call may try again."""
        if self._is_torn:
            self._cut_torn_end()
        try:
            written = os.write(self._file, data)
            while written < len(data):
                written += os.write(self._file, data[written:])
        except OSError:
            self._is_torn = True
            try:
                self._cut_torn_end()
            except OSError:
                # Tried again before the next row; a file that has disappeared cannot be truncated.
                pass
            raise
        self.length += len(data)

    def finish(self) -> None:
        """Writes the end of the file: nothing for a plain one."""

    def sync(self) -> None:
        """Waits until everything is on the disk. Only for a thread that has nothing else to do."""
        os.fsync(self._file)

    def close(self) -> None:
        os.close(self._file)

    def _cut_torn_end(self) -> None:
        os.ftruncate(self._file, self.length)
        os.lseek(self._file, self.length, os.SEEK_SET)
        self._is_torn = False


class GzipFile(AppendFile):
    """A gzipped bag.

    Each `append` ends on a byte's boundary (zlib's sync flush). So a file that is cut later can be inflated up to there.
    """

    def __init__(self, path: Path) -> None:
        super().__init__(path)
        self._deflater = _deflater()
        self._checksum = 0
        self._unpacked_length = 0

    def append(self, data: bytes) -> None:
        self._write(self._deflater.compress(data) + self._deflater.flush(zlib.Z_SYNC_FLUSH))
        self._checksum = zlib.crc32(data, self._checksum)
        self._unpacked_length += len(data)

    def finish(self) -> None:
        trailer = self._checksum.to_bytes(4, "little") + (self._unpacked_length & 0xFFFFFFFF).to_bytes(4, "little")
        self._write(self._deflater.flush(zlib.Z_FINISH) + trailer)

    def _write(self, packed: bytes) -> None:
        try:
            super().append(packed if self.length > 0 else _GZIP_HEADER + packed)
        except OSError:
            # The following bytes must not refer to bytes that are not in the file. The stream continues from the last success.
            self._deflater = _deflater()
            raise


def _deflater() -> zlib._Compress:
    return zlib.compressobj(zlib.Z_DEFAULT_COMPRESSION, zlib.DEFLATED, -zlib.MAX_WBITS)
