package badlog.viewer.input

/** What a drag over a graph does. */
enum class DragKind {
    /** Zooms to what it covers. */
    ZOOM,

    /** Zooms to what it covers of y, only in its graph. */
    ZOOM_Y,

    /** Selects what it covers. */
    SELECT,

    /** Moves the graphs. */
    PAN,
    ;

    companion object {
        /** Returns what a drag with the primary button does while these keys are held. */
        fun of(shift: Boolean, alt: Boolean): DragKind = when {
            shift -> PAN
            alt -> ZOOM_Y
            else -> ZOOM
        }

        /** The minimum distance of a drag, in CSS pixels or dp. */
        const val MIN_DISTANCE: Double = 4.0
    }
}
