package badlog.viewer.app

/** What the pointer does. */
internal val GESTURES = listOf(
    GestureHelp("On the graphs", "Move, click", "Moves the cursor, and pins it."),
    GestureHelp("On the graphs", "Wheel", "Zooms in and out of x; with Shift it moves along."),
    GestureHelp("On the graphs", "Drag", "Zooms in to what it goes over."),
    GestureHelp("On the graphs", "Shift+drag", "Zooms in on y, of this graph."),
    GestureHelp("On the graphs", "Ctrl+drag", "Selects a part, as a drag with the right button does."),
    GestureHelp("On the graphs", "Alt+drag", "Moves along, as the middle button and a drag of the axis do."),
    GestureHelp("On the graphs", "Double click", "Shows everything again."),
    GestureHelp("Topics", "Click", "Draws the topic in a graph of its own, or takes that away."),
    GestureHelp("Topics", "Ctrl+click, Shift+click", "Chooses one more, or all up to it."),
    GestureHelp("Topics", "Drag", "Takes the topic, or all chosen ones, to a graph."),
    GestureHelp("Topics", "Right click", "Says what else can be done with it."),
    GestureHelp("Events", "Click", "Takes the cursor to the event."),
    GestureHelp("Findings", "Point at a diamond, click", "Tells the finding, and takes the cursor there."),
    GestureHelp("Statistics table", "Click a heading", "Sorts by it; again, the other way round."),
    GestureHelp("Statistics table", "Double-click a row", "Opens its recording."),
)
