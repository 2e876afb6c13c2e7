package badlog.viewer.app

/** What the pointer does in the list of topics and in the panels. */
internal val PANEL_GESTURES = listOf(
    GestureHelp("Topics", "Click", "Draws the topic in a graph of its own, or takes that away."),
    GestureHelp("Topics", "Ctrl+click, Shift+click", "Chooses one more, or all up to it."),
    GestureHelp("Topics", "Drag", "Takes the topic, or all chosen ones, to a graph."),
    GestureHelp("Topics", "Right click", "Says what else can be done with it."),
    GestureHelp("Events", "Click", "Takes the cursor to the event."),
    GestureHelp("Statistics table", "Click a heading", "Sorts by it; again, the other way round."),
    GestureHelp("Statistics table", "Double-click a row", "Opens its recording."),
)
