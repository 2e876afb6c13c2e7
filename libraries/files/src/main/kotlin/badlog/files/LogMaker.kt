package badlog.files

import badlog.core.recording.Problem
import java.nio.file.Path

/** Makes one log from a file that contains several. */
public interface LogMaker {
    /** Returns whether [file], which begins with the bytes [head], is such a file. */
    public fun isSource(file: Path, head: ByteArray): Boolean

    /**
     * Writes the logs in [file] to [made], as one WPILOG, and returns the problems found on the way.
     *
     * @param checkpoint called from time to time; may throw to cancel.
     * @throws NotReadException if the logs cannot be made into one.
     * @throws UnreadableFileException if it cannot be read.
     * @throws UnwritableFileException if the WPILOG cannot be written.
     */
    public fun make(file: Path, made: Path, checkpoint: () -> Unit): List<Problem>
}
