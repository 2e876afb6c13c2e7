package badlog.window.app

import badlog.viewer.input.GRAPH_GESTURES
import badlog.viewer.input.HelpLine

/** The help for gestures of the pointer. Over graphs, most gestures are the same as on an exported page. */
internal val GESTURES = GRAPH_GESTURES + listOf(
    HelpLine("On the graphs", "Click in a legend", "Hides the line, or shows it again."),
    HelpLine("On the graphs", "Drag a title", "Moves the graph; dropped on another graph, adds its lines to that one."),
    HelpLine("On the graphs", "Right click a title, Shift+F10", "Opens a menu: show only this graph, change its height or its y limits."),
    HelpLine("On the graphs", "Ctrl+drag", "Selects a range, like a drag with the right button."),
    HelpLine("On the graphs", "Middle button", "Pans, like a drag on the axis."),
    HelpLine("On the graphs", "Ctrl+Shift+wheel", "Makes all graphs taller or shorter."),
    HelpLine("Topics", "Click", "Draws the topic in its own graph; click again to remove it."),
    HelpLine("Topics", "Ctrl+click, Shift+click", "Selects one more topic, or all topics up to this one."),
    HelpLine("Topics", "Drag", "Adds the topic, or all selected ones, to a graph."),
    HelpLine("Topics", "Right click, Shift+F10", "Opens a menu with more actions, also for a folder."),
    HelpLine("Events", "Click", "Moves the cursor to the event."),
    HelpLine("Findings", "Point at a mark, click", "Shows the finding, and moves the cursor there."),
    HelpLine("Statistics table", "Click a heading", "Sorts by it; again, in reverse."),
    HelpLine("Statistics table", "Double-click a row", "Opens its log."),
)
