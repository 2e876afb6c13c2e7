package badlog.viewer.input

/** The effect of a drag over a graph. */
enum class DragKind {
    /** Zooms to the dragged range of x. */
    ZOOM,

    /** Zooms to the dragged range of y, only in its graph. */
    ZOOM_Y,

    /** Selects the dragged range. */
    SELECT,

    /** Moves the graphs. */
    PAN,
    ;

    companion object {
        /** Returns the effect of a drag with the primary button while these keys are held. */
        fun of(shift: Boolean, alt: Boolean): DragKind = when {
            shift -> PAN
            alt -> ZOOM_Y
            else -> ZOOM
        }

        /** The minimum distance of a drag, in CSS pixels or dp. */
        const val MIN_DISTANCE: Double = 4.0
    }
}
