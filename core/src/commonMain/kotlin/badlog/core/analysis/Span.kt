package badlog.core.analysis

/**
 * A part of an axis.
 *
 * @property from where it begins.
 * @property to where it ends; not before [from].
 */
public data class Span(public val from: Double, public val to: Double) {
    /** The length, in the unit of the axis. */
    public val width: Double get() = to - from

    /** Returns whether [position] lies in it; both ends are included. */
    public operator fun contains(position: Double): Boolean = position in from..to
}
