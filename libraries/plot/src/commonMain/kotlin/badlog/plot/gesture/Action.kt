package badlog.plot.gesture

/**
 * What a key does, on the page as in the window.
 *
 * @property group under which heading the help sheet has it.
 * @property meaning what it does, as the help sheet says it.
 * @property keys what to press; each does the same.
 */
public enum class Action(public val group: String, public val meaning: String, public vararg val keys: KeyStroke) {
    /** The cursor goes to the sample before. */
    PREVIOUS_SAMPLE("Graphs", "Cursor to the previous sample", KeyStroke("←")),

    /** The cursor goes to the next sample. */
    NEXT_SAMPLE("Graphs", "Cursor to the next sample", KeyStroke("→")),

    /** The cursor goes back by ten samples. */
    TEN_SAMPLES_BACK("Graphs", "Cursor ten samples back", KeyStroke("←", shift = true)),

    /** The cursor goes on by ten samples. */
    TEN_SAMPLES_ON("Graphs", "Cursor ten samples forward", KeyStroke("→", shift = true)),

    /** A second cursor is put where the first one is, and moved from then on; or taken away. */
    SECOND_CURSOR("Graphs", "Second cursor, moved by the arrow keys; again: remove it", KeyStroke("B")),

    /** Less of x is shown, around the cursor where it is in sight. */
    ZOOM_IN("Graphs", "Zoom in", KeyStroke("+")),

    /** More of x is shown. */
    ZOOM_OUT("Graphs", "Zoom out", KeyStroke("-")),

    /** All of x is shown. */
    SHOW_ALL("Graphs", "Show everything", KeyStroke("0"), KeyStroke("Home")),

    /** What was shown before is shown. */
    PREVIOUS_VIEW("Graphs", "Previous view", KeyStroke("Backspace")),

    /** What [PREVIOUS_VIEW] led away from is shown. */
    NEXT_VIEW("Graphs", "Next view", KeyStroke("Backspace", shift = true)),

    /** The time is shown during which the robot was enabled. */
    SHOW_ENABLED("Graphs", "Zoom to the time enabled", KeyStroke("E")),

    /** Earlier x is shown. */
    PAN_LEFT("Graphs", "Move to the left", KeyStroke("[")),

    /** Later x is shown. */
    PAN_RIGHT("Graphs", "Move to the right", KeyStroke("]")),

    /** The values of many topics at the cursor are shown, or no longer. */
    CURSOR_VALUES("Graphs", "Values at the cursor: open or close", KeyStroke("V")),

    /** The graph goes on the board, or off it. */
    PIN("Board", "Add the graph to the board, or remove it", KeyStroke("P")),

    /** The graph changes places with the one above it. */
    MOVE_UP("Board", "Move the graph up", KeyStroke("↑", alt = true)),

    /** The graph changes places with the one below it. */
    MOVE_DOWN("Board", "Move the graph down", KeyStroke("↓", alt = true)),

    /** The graph becomes as high as the next of three heights. */
    NEXT_HEIGHT("Board", "Next height of the graph", KeyStroke("H")),

    /** The board becomes what it was before. */
    UNDO("Board", "Undo", KeyStroke("Z", ctrl = true)),

    /** What [UNDO] led away from is shown. */
    REDO("Board", "Redo", KeyStroke("Z", shift = true, ctrl = true), KeyStroke("Y", ctrl = true)),

    /** A person may write a formula. */
    NEW_FORMULA("Formulas", "New formula", KeyStroke("F")),

    /** The cursor goes to the next finding. */
    NEXT_FINDING("Findings", "Next finding", KeyStroke("N")),

    /** The cursor goes to the finding before. */
    PREVIOUS_FINDING("Findings", "Previous finding", KeyStroke("N", shift = true)),

    /** The video shows the frame before, and the cursor goes there. */
    PREVIOUS_FRAME("Video", "Previous frame of the video", KeyStroke(",")),

    /** The video shows the next frame, and the cursor goes there. */
    NEXT_FRAME("Video", "Next frame of the video", KeyStroke(".")),
    ;

    /** The first of [keys], for the tip of a button: `Shift+N`. */
    public val shortcut: String get() = keys[0].text

    /** As the help sheet has it. */
    public val help: HelpLine get() = HelpLine(group, keys.joinToString("  ") { it.text }, meaning)

    public companion object {
        /** How many samples the cursor goes with Shift. */
        public const val MANY_SAMPLES: Int = 10

        /** Which part of what is seen [PAN_LEFT] and [PAN_RIGHT] move by. */
        public const val PAN_SHARE: Double = 0.25

        /** What [key], which is written as in [keys], does while these are held, [ctrl] being the command key on a Mac; null for nothing. */
        public fun of(key: String, shift: Boolean, ctrl: Boolean = false, alt: Boolean = false): Action? = entries.firstOrNull { action ->
            action.keys.any { it.key == key && it.ctrl == ctrl && it.alt == alt && (it.shift == shift || it.isSign) }
        }
    }
}

/**
 * A key with the modifiers that must be held.
 *
 * @property key what stands on it.
 */
public class KeyStroke(
    public val key: String,
    public val shift: Boolean = false,
    public val ctrl: Boolean = false,
    public val alt: Boolean = false,
) {
    /** Whether it is a sign, for which some keyboards need Shift and others do not. */
    public val isSign: Boolean get() = key.length == 1 && key[0] < 'A'

    /** As the help sheet writes it: `Ctrl+Shift+Z`. */
    public val text: String
        get() = listOfNotNull("Ctrl".takeIf { ctrl }, "Alt".takeIf { alt }, "Shift".takeIf { shift }, key).joinToString("+")
}

/**
 * Something that can be done, as the help sheet has it.
 *
 * @property group under which heading.
 * @property how what to press, or what to do with the pointer.
 * @property meaning what comes of it.
 */
public data class HelpLine(public val group: String, public val how: String, public val meaning: String)

/** What the pointer does over graphs, on the page as in the window. */
public val GRAPH_GESTURES: List<HelpLine> = listOf(
    HelpLine("On the graphs", "Wheel", "Scrolls."),
    HelpLine("On the graphs", "Ctrl+wheel, pinch", "Zooms around the pointer."),
    HelpLine("On the graphs", "Shift+wheel", "Pans, like a sideways wheel."),
    HelpLine("On the graphs", "Drag", "Zooms to the range it covers."),
    HelpLine("On the graphs", "Shift+drag", "Pans."),
    HelpLine("On the graphs", "Alt+drag", "Zooms y of this graph."),
    HelpLine("On the graphs", "Double click", "Shows everything again."),
    HelpLine("On the graphs", "Click", "Pins the cursor; on the cursor, unpins it."),
    HelpLine("On the graphs", "Shift+click", "Sets a second cursor: difference and slope of each line, and statistics between both."),
    HelpLine("On the overview", "Drag", "Moves the visible range or one of its edges; outside it, selects a new one."),
    HelpLine("On the overview", "Click", "Moves the visible range there."),
)
