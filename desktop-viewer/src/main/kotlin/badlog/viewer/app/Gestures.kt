package badlog.viewer.app

import badlog.plot.gesture.GRAPH_GESTURES
import badlog.plot.gesture.HelpLine

/** What the pointer does: over graphs most of it as on an exported page. */
internal val GESTURES = GRAPH_GESTURES + listOf(
    HelpLine("On the graphs", "Click in a legend", "Hides the line, or shows it again."),
    HelpLine("On the graphs", "Drag a title", "Moves the graph; onto another one, draws it there."),
    HelpLine("On the graphs", "Right click a title", "Opens a menu: only this graph, its height, its limits of y."),
    HelpLine("On the graphs", "Ctrl+drag", "Selects a part, as a drag with the right button does."),
    HelpLine("On the graphs", "Middle button", "Pans, as a drag of the axis does."),
    HelpLine("On the graphs", "Ctrl+Shift+wheel", "Makes all graphs taller or shorter."),
    HelpLine("Topics", "Click", "Draws the topic in a graph of its own, or removes it."),
    HelpLine("Topics", "Ctrl+click, Shift+click", "Selects one more, or all up to it."),
    HelpLine("Topics", "Drag", "Adds the topic, or all selected ones, to a graph."),
    HelpLine("Topics", "Right click", "Opens a menu with more actions."),
    HelpLine("Events", "Click", "Moves the cursor to the event."),
    HelpLine("Findings", "Point at a mark, click", "Shows the finding, and moves the cursor there."),
    HelpLine("Statistics table", "Click a heading", "Sorts by it; again, in reverse."),
    HelpLine("Statistics table", "Double-click a row", "Opens its log."),
)
