package badlog.plot.path

import badlog.analysis.Span
import badlog.rules.path.Trail

/** The field that paths are on: its outline and its middle line, in meters from the corner at the right of the blue alliance's wall. */
public object Field {
    /** How long it is, from the blue alliance's wall to the red one's; that of 2026, as WPILib's layout of its tags has it. */
    public const val LENGTH: Double = 16.541

    /** How wide it is. */
    public const val WIDTH: Double = 8.069

    /** All of it, and what lies around it where [trails] leave it. */
    internal fun around(trails: List<Trail>): Plane {
        fun spanOf(length: Double, spans: List<Span?>) = Span(
            minOf(0.0, spans.minOfOrNull { it?.from ?: 0.0 } ?: 0.0).coerceAtLeast(-length) - MARGIN,
            maxOf(length, spans.maxOfOrNull { it?.to ?: 0.0 } ?: 0.0).coerceAtMost(2 * length) + MARGIN,
        )
        return Plane(spanOf(LENGTH, trails.map { it.xSpan }), spanOf(WIDTH, trails.map { it.ySpan }))
    }

    private const val MARGIN = 0.3
}
