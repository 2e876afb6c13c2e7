package badlog.files

import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording

/**
 * Returns this recording with one more [problem][ProblemKind.GZIP_CUT], before all others. It says that the gzip stream ended early, after
 * [inflatedBytes] bytes; the rows do not show that.
 */
public fun Recording.withGzipCut(inflatedBytes: Long): Recording = copy(problems = listOf(compressedCut(inflatedBytes)) + problems)

/** Returns the problem that a compressed file could only be inflated to [inflatedBytes] bytes. */
internal fun compressedCut(inflatedBytes: Long): Problem =
    Problem(ProblemKind.GZIP_CUT, "The compressed file is cut off or damaged; the $inflatedBytes bytes before that were read.")
