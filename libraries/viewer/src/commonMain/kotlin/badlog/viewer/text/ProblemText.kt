package badlog.viewer.text

import badlog.core.recording.Problem

/** Returns where [problem] occurred, and how often if its message does not say it: `line 12 · Arm/Angle · 3 times`. */
fun placeTextOf(problem: Problem): String = listOfNotNull(
    problem.line?.let { "line ${countText(it)}" },
    problem.topic,
    problem.count.takeIf { it > 1 && !problem.message.contains(Regex("\\b$it\\b")) }?.let { "${countText(it)} times" },
).joinToString(" · ")
