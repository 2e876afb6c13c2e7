package badlog.signals.match.files

import badlog.signals.clock.ClockedLog
import badlog.signals.clock.timeInName
import badlog.signals.match.isSameAs
import badlog.signals.match.matchInName

/**
 * Returns whether the names of a file and its folder show that it is of this log's match.
 *
 * The [name] of the file counts, or the name of its [folder] if the file has no number or time. A contradicting number excludes the file. A
 * time in the name must be during the log, or, if the number is the same, within a day of it, since cameras write the time of their own
 * zone.
 */
fun ClockedLog.isNamedAlike(name: String, folder: String): Boolean {
    val named = matchInName(name).takeIf { it.number != null } ?: matchInName(folder)
    val isSame = match.isSameAs(named)
    if (isSame == false) return false
    val begin = start
    val time = timeInName(name) ?: timeInName(folder)
    if (begin == null || time == null || !hasClock) return isSame == true
    val around = if (isSame == true) DAY else AROUND
    return time in begin + first - around..begin + last + around
}

/** In s: devices and cameras start before the robot's log, and go on after it. */
private const val AROUND = 60.0
private const val DAY = 86_400.0
