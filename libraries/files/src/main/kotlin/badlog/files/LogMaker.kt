package badlog.files

import badlog.core.recording.Problem
import java.nio.file.Path

/** Makes one log of a file that has several in it. */
public interface LogMaker {
    /** Returns whether [file], which begins with the bytes [head], is such a file. */
    public fun isSource(file: Path, head: ByteArray): Boolean

    /**
     * Writes a WPILOG of the logs in [file] to [made], and returns the problems found on the way.
     *
     * @param checkpoint called from time to time; may throw to cancel.
     * @throws NotReadException if that cannot be one log.
     * @throws UnreadableFileException if it cannot be read.
     * @throws UnwritableFileException if the WPILOG cannot be written.
     */
    public fun make(file: Path, made: Path, checkpoint: () -> Unit): List<Problem>
}
