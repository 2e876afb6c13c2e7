package badlog.page.reading

import badlog.recording.Problem
import badlog.recording.Recording

/** This recording with one more problem, which its bytes alone do not show. */
internal operator fun Recording.plus(problem: Problem): Recording = copy(problems = problems + problem)
