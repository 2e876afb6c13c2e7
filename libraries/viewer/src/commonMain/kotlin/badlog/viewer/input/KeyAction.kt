package badlog.viewer.input

/**
 * The effect of a key, on the page and in the window.
 *
 * @property group the heading in the help.
 * @property meaning the effect, for the help.
 * @property keys the keys, each with the same effect.
 */
enum class KeyAction(val group: String, val meaning: String, vararg val keys: KeyStroke) {
    /** Moves the cursor to the previous sample. */
    PREVIOUS_SAMPLE("Graphs", "Cursor to the previous sample", KeyStroke("←")),

    /** Moves the cursor to the next sample. */
    NEXT_SAMPLE("Graphs", "Cursor to the next sample", KeyStroke("→")),

    /** Moves the cursor back ten samples. */
    TEN_SAMPLES_BACK("Graphs", "Cursor ten samples back", KeyStroke("←", shift = true)),

    /** Moves the cursor forward ten samples. */
    TEN_SAMPLES_ON("Graphs", "Cursor ten samples forward", KeyStroke("→", shift = true)),

    /** Puts a second cursor at the first one, for the arrow keys to move; or removes it. */
    SECOND_CURSOR("Graphs", "Second cursor, moved by the arrow keys; again: remove it", KeyStroke("B")),

    /** Zooms in on x, around the cursor if it is visible. */
    ZOOM_IN("Graphs", "Zoom in", KeyStroke("+")),

    /** Zooms out on x. */
    ZOOM_OUT("Graphs", "Zoom out", KeyStroke("-")),

    /** Shows all of x. */
    SHOW_ALL("Graphs", "Show everything", KeyStroke("0"), KeyStroke("Home")),

    /** Shows the previous view. */
    PREVIOUS_VIEW("Graphs", "Previous view", KeyStroke("Backspace")),

    /** Shows the view that [PREVIOUS_VIEW] left. */
    NEXT_VIEW("Graphs", "Next view", KeyStroke("Backspace", shift = true)),

    /** Shows the time during which the robot was enabled. */
    SHOW_ENABLED("Graphs", "Zoom to the time enabled", KeyStroke("E")),

    /** Moves the visible range to the left. */
    PAN_LEFT("Graphs", "Move to the left", KeyStroke("[")),

    /** Moves the visible range to the right. */
    PAN_RIGHT("Graphs", "Move to the right", KeyStroke("]")),

    /** Opens or closes the values of many topics at the cursor. */
    CURSOR_VALUES("Graphs", "Values at the cursor: open or close", KeyStroke("V")),

    /** Opens or closes the modules of a swerve drive at the cursor. */
    MODULES("Graphs", "Swerve modules: open or close", KeyStroke("W")),

    /** Adds the graph to the board, or removes it. */
    PIN("Board", "Add the graph to the board, or remove it", KeyStroke("P")),

    /** Swaps the graph with the one above it. */
    MOVE_UP("Board", "Move the graph up", KeyStroke("↑", alt = true)),

    /** Swaps the graph with the one below it. */
    MOVE_DOWN("Board", "Move the graph down", KeyStroke("↓", alt = true)),

    /** Moves the graph above all others. */
    MOVE_TO_TOP("Board", "Move the graph to the top", KeyStroke("↑", alt = true, shift = true)),

    /** Switches the graph to the next of three heights. */
    NEXT_HEIGHT("Board", "Next height of the graph", KeyStroke("H")),

    /** Undoes the last change of the board. */
    UNDO("Board", "Undo", KeyStroke("Z", ctrl = true)),

    /** Redoes the change that [UNDO] undid. */
    REDO("Board", "Redo", KeyStroke("Z", shift = true, ctrl = true), KeyStroke("Y", ctrl = true)),

    /** Shows the graphs of the next kept layout. */
    NEXT_LAYOUT("Board", "Next kept layout", KeyStroke("G")),

    /** Shows the graphs of the previous kept layout. */
    PREVIOUS_LAYOUT("Board", "Previous kept layout", KeyStroke("G", shift = true)),

    /** Opens the dialog for a new formula. */
    NEW_FORMULA("Formulas", "New formula", KeyStroke("F")),

    /** Begins a note at the cursor, or in the middle of the visible range. */
    NEW_NOTE("Notes", "Write a note at the cursor", KeyStroke("M")),

    /** Adds a note without asking for its text. It is at the newest moment of a growing log, otherwise where [NEW_NOTE] begins one. */
    MARK(
        "Notes",
        "Mark the time at the cursor, or the newest time of a growing log: a note without typing",
        KeyStroke("M", shift = true),
    ),

    /** Moves the cursor to the next finding. */
    NEXT_FINDING("Findings", "Next finding", KeyStroke("N")),

    /** Moves the cursor to the previous finding. */
    PREVIOUS_FINDING("Findings", "Previous finding", KeyStroke("N", shift = true)),

    /** Shows the previous frame of the video, and moves the cursor there. */
    PREVIOUS_FRAME("Video", "Previous frame of the video", KeyStroke(",")),

    /** Shows the next frame of the video, and moves the cursor there. */
    NEXT_FRAME("Video", "Next frame of the video", KeyStroke(".")),
    ;

    /** The first of [keys], for the tooltip of a button: `Shift+N`. */
    val shortcut: String get() = keys[0].text

    /** The key's line in the help. */
    val help: HelpLine get() = HelpLine(group, keys.joinToString("  ") { it.text }, meaning)

    companion object {
        /** The number of samples by which the cursor moves with Shift. */
        const val MANY_SAMPLES: Int = 10

        /** The part of the visible range by which [PAN_LEFT] and [PAN_RIGHT] move. */
        const val PAN_SHARE: Double = 0.25

        /**
         * Returns the action of [key], written as in [keys], with these modifiers; [ctrl] is the command key on a Mac. Null if there is
         * none.
         */
        fun of(key: String, shift: Boolean, ctrl: Boolean = false, alt: Boolean = false): KeyAction? = entries.firstOrNull { action ->
            action.keys.any { it.key == key && it.ctrl == ctrl && it.alt == alt && (it.shift == shift || it.isSign) }
        }
    }
}

/**
 * A key with the modifiers that must be held.
 *
 * @property key its label.
 */
class KeyStroke(val key: String, val shift: Boolean = false, val ctrl: Boolean = false, val alt: Boolean = false) {
    /** Whether [key] is a character other than a letter. Some keyboards need Shift for it, and others do not. */
    val isSign: Boolean get() = key.length == 1 && key[0] < 'A'

    /** The text in the help: `Ctrl+Shift+Z`. */
    val text: String
        get() = listOfNotNull("Ctrl".takeIf { ctrl }, "Alt".takeIf { alt }, "Shift".takeIf { shift }, key).joinToString("+")
}

/**
 * A line of the help.
 *
 * @property group the heading.
 * @property how the key to press, or the gesture of the pointer.
 * @property meaning the effect.
 */
data class HelpLine(val group: String, val how: String, val meaning: String)

/** The effects of the pointer over graphs, on the page and in the window. */
val GRAPH_GESTURES: List<HelpLine> = listOf(
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

/**
 * A key of page and window for anything but the graphs.
 *
 * @property group the heading in the help.
 * @property meaning the effect, for the help.
 * @property key the key in the window.
 * @property onPage the key on the page: browsers scroll with Page up and Page down.
 */
enum class ScreenKey(val group: String, val meaning: String, val key: KeyStroke, val onPage: KeyStroke = key) {
    /** Shows the log that arrived last, at its worst finding. */
    NEW_LOG("Logs", "Show the newest log, at its worst finding", KeyStroke("A")),

    /** Opens or closes the pit view. */
    PIT("Logs", "Pit view: the last logs in large letters, or back", KeyStroke("I")),

    /** Opens the previous log of the list. */
    PREVIOUS_LOG("Logs", "Open the previous log of the list", KeyStroke("Page up"), KeyStroke("Page up", alt = true)),

    /** Opens the next log of the list. */
    NEXT_LOG("Logs", "Open the next log of the list", KeyStroke("Page down"), KeyStroke("Page down", alt = true)),

    /** Opens or closes the help. */
    HELP("Help", "Open or close this help", KeyStroke("?")),
    ;

    /** The key's line in the help of a page. */
    val helpOnPage: HelpLine get() = HelpLine(group, onPage.text, meaning)

    companion object {
        /** Returns the page's key for [key], written as in [KeyStroke.key], with these modifiers; null if there is none. */
        fun onPage(key: String, shift: Boolean, alt: Boolean): ScreenKey? =
            entries.firstOrNull { it.onPage.run { this.key == key && this.alt == alt && (this.shift == shift || isSign) } }
    }
}
