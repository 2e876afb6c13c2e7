package badlog.viewer.formula

/**
 * The sheet in which a person writes a formula.
 *
 * @property before the definition that is changed; null for a new one.
 * @property start the text it begins with.
 */
internal data class FormulaSheet(val before: String? = null, val start: String = before.orEmpty())
