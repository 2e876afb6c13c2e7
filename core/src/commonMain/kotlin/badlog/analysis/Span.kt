package badlog.analysis

/**
 * A part of an axis.
 *
 * @property from where it begins.
 * @property to where it ends; not before [from].
 */
public data class Span(public val from: Double, public val to: Double) {
    /** How long it is, in the axis' unit. */
    public val width: Double get() = to - from

    /** Whether [position] lies in it; both ends do. */
    public operator fun contains(position: Double): Boolean = position in from..to
}
