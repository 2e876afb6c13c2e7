package badlog.expression

/**
 * What an expression may name.
 *
 * @property name the full name; `/` makes folders.
 * @property kind what its samples are.
 * @property unit the unit, `ul` or empty for none; only shown, never calculated with.
 */
public data class Signal(public val name: String, public val kind: SignalKind, public val unit: String = "")
