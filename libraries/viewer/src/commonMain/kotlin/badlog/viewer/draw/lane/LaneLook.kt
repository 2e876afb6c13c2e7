package badlog.viewer.draw.lane

/** The tone of a block of a lane. */
enum class LaneTone {
    /** An almost colorless tone, so that the time when a switch is pressed stands out. */
    OFF,

    /** The state's color, muted enough for a name on top of it. */
    QUIET,

    /** The state's full color: a few pixels of a muted color would be invisible. */
    STRONG,
    ;

    companion object {
        /** Returns the tone of a block in [state], one of [states], that is [width] density-independent pixels wide. */
        fun of(states: List<String>, state: Int, width: Double): LaneTone = when {
            state == 0 && states.size == 2 && states[0] == "false" -> OFF
            width < NARROW -> STRONG
            else -> QUIET
        }

        private const val NARROW = 4.0
    }
}

/** Dimensions of all lanes, in CSS pixels of the page or dp of the window. */
object LaneLook {
    /** The height of a lane, with the space to the next one. */
    const val HEIGHT: Int = 18

    /** The minimum width of a block. */
    const val MIN_BLOCK: Double = 1.5

    /** The font size of a state's name. */
    const val LETTERS: Double = 11.0

    /** The space on either side of a name. */
    const val MARGIN: Double = 5.0

    /**
     * Returns whether [room] pixels are enough for a name, or for its beginning and `…`. Only a few letters would mean nothing, or look
     * like another state's name.
     */
    fun hasRoom(room: Double, isWhole: Boolean): Boolean = room >= if (isWhole) LETTERS else PART

    private const val PART = 40.0
}
