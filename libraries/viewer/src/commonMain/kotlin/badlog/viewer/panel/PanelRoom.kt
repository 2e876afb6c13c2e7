package badlog.viewer.panel

/** The room for a panel. */
enum class PanelRoom {
    /** The panel has its own pane, which scrolls. */
    WHOLE,

    /** The panel is above graphs, which should stay visible. */
    SHARED,

    /** The panel is above graphs on a phone. */
    NARROW,

    /** The panel is printed, so nothing in it can be unfolded. */
    PAPER,
}
