package badlog.viewer.shown.swerve

/**
 * Returns which of [modules] is worse than the others, in sentences for people; that they are alike, if none is. Only a module that is
 * clearly worse is named: always naming one would send people to healthy ones.
 */
fun worstModuleText(modules: List<ModuleError>): String {
    val angles = modules.mapNotNull { module -> module.angle?.let { Named(module.label, it.rms) } }
    val speeds = modules.mapNotNull { module -> module.speed?.let { Named(module.label, it.rms) } }
    if (angles.isEmpty()) return "No module drives in the visible range."
    if (angles.size < modules.size) return "Not every module drives in the visible range."
    val angle = sentenceOf(angles, "angle", ErrorUnit.DEGREES, CLEAR_DEGREES)
    val speed = if (speeds.size == modules.size) sentenceOf(speeds, "speed", ErrorUnit.SPEED, CLEAR_SPEED) else null
    return listOfNotNull(angle, speed).joinToString(" ").ifEmpty {
        val least = angles.minOf { it.rms }
        val most = angles.maxOf { it.rms }
        val range = ErrorUnit.DEGREES.textOf(least, most)
        val areAlike = most < least * ALIKE || most - least < CLEAR_DEGREES
        if (areAlike) "The modules are alike: $range RMS." else "No module stands out: $range RMS."
    }
}

private class Named(val label: String, val rms: Double)

/** Returns the sentence about the worst of [modules]; null unless it is clearly worse than the second worst, by at least [clear]. */
private fun sentenceOf(modules: List<Named>, quantity: String, unit: ErrorUnit, clear: Double): String? {
    val (worst, second) = modules.sortedByDescending { it.rms }
    if (worst.rms < second.rms * WORSE || worst.rms - second.rms < clear) return null
    val others = modules.filter { it !== worst }
    val range = unit.textOf(others.minOf { it.rms }, second.rms)
    return "${worst.label} has the largest $quantity error: ${unit.textOf(worst.rms)} RMS, the others $range."
}

private const val WORSE = 1.5
private const val ALIKE = 1.5

/** What a difference is at least that anybody would look for, in degrees. */
private const val CLEAR_DEGREES = 1.0

/** The same in m/s. */
private const val CLEAR_SPEED = 0.1
