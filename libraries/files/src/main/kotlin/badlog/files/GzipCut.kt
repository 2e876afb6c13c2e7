package badlog.files

import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording

/**
 * Returns this recording with one more [problem][ProblemKind.GZIP_CUT], before all others. The gzip stream it was read from ended early
 * after [inflatedBytes] bytes, which its rows do not show.
 */
public fun Recording.withGzipCut(inflatedBytes: Long): Recording = copy(problems = listOf(compressedCut(inflatedBytes)) + problems)

/** Returns the problem that only [inflatedBytes] of a compressed file could be inflated. */
internal fun compressedCut(inflatedBytes: Long): Problem =
    Problem(ProblemKind.GZIP_CUT, "The compressed file is cut off or damaged; the $inflatedBytes bytes before that were read.")
