package badlog.plot.lane

/** How a block of a lane is colored. */
public enum class LaneTone {
    /** As good as not at all: where a switch is pressed has to be seen at a glance, so where it is not is quiet. */
    OFF,

    /** In the state's color, quiet enough for a name upon it. */
    QUIET,

    /** In the state's full color: nobody sees a few pixels of a quiet one. */
    STRONG,
    ;

    public companion object {
        /** The tone of a block in [state], one of [states], that looks [width] pixels wide. */
        public fun of(states: List<String>, state: Int, width: Double): LaneTone = when {
            state == 0 && states.size == 2 && states[0] == "false" -> OFF
            width < NARROW -> STRONG
            else -> QUIET
        }

        private const val NARROW = 4.0
    }
}

/** What all lanes have in common, in pixels as they look: of the page, or of the window's density. */
public object LaneLook {
    /** How high a lane is, with the room to the next. */
    public const val HEIGHT: Int = 18

    /** How wide the shortest state is. */
    public const val MIN_BLOCK: Double = 1.5

    /** How high the letters of a state's name are. */
    public const val LETTERS: Double = 11.0

    /** What stays free on either side of a name. */
    public const val MARGIN: Double = 5.0

    /** Whether a name, or its beginning and `…`, may stand on [room] pixels: a few letters say nothing, or what another state is called. */
    public fun hasRoom(room: Double, isWhole: Boolean): Boolean = room >= if (isWhole) LETTERS else PART

    private const val PART = 40.0
}
