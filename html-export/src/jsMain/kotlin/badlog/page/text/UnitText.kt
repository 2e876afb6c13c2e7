package badlog.page.text

import badlog.analysis.Units

/** A unit as it is shown: nothing for none. */
internal fun unitText(unit: String): String = if (Units.isNone(unit)) "" else unit

/** A number and its unit. */
internal fun withUnit(number: String, unit: String): String = if (Units.isNone(unit)) number else "$number $unit"
