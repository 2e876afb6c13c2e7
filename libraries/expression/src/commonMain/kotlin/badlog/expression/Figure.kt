package badlog.expression

/**
 * A number that belongs to an answer.
 *
 * @property name the part of the expression that it is, as it was written, or what was made of it to have one number.
 * @property value the number; NaN when there is none.
 * @property unit its unit where it is known, else empty.
 * @property time where it was found, in the unit of the recording's x; NaN where it has no place.
 */
public data class Figure(public val name: String, public val value: Double, public val unit: String, public val time: Double) {
    /** The number with its unit, in six digits at most: `6.7 V`. */
    public val text: String get() = readable(value) + if (unit.isEmpty() || !value.isFinite()) "" else " $unit"

    /** Such as `min(Battery Voltage) = 6.7 V`. */
    override fun toString(): String = "$name = $text"
}
