package badlog.expression

/**
 * What an expression gives.
 *
 * @property isCondition whether true and false, rather than numbers.
 * @property isOverTime whether one for each moment, rather than one for the whole recording.
 */
public data class ExpressionType(public val isCondition: Boolean, public val isOverTime: Boolean)
