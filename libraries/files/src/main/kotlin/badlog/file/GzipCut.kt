package badlog.file

import badlog.recording.Problem
import badlog.recording.ProblemKind
import badlog.recording.Recording

/**
 * This recording with the [problem][ProblemKind.GZIP_CUT], before all others, that the gzip stream it was read from broke
 * off after [inflatedBytes] bytes, which its rows do not show.
 */
public fun Recording.withGzipCut(inflatedBytes: Long): Recording = copy(problems = listOf(compressedCut(inflatedBytes)) + problems)

/** The problem that a compressed file gave only [inflatedBytes]. */
internal fun compressedCut(inflatedBytes: Long): Problem =
    Problem(ProblemKind.GZIP_CUT, "The compressed file is cut off or damaged; the $inflatedBytes bytes before that were read.")
