package badlog.core.analysis

import badlog.core.recording.PathName

/**
 * One or more series that are drawn in one frame over the common x.
 *
 * @property name the full name, with its folder.
 * @property unit the unit of y, `ul` for none; the first series' unit if they differ.
 * @property isVirtual whether it was derived from topics rather than logged; its [title] is then in brackets.
 * @property isFilled whether the area below the line is filled.
 * @property includesZero whether y must include 0.
 * @property series the lines, in the order in which they were added; never empty.
 */
public class Graph(
    public val name: String,
    public val unit: String,
    public val isVirtual: Boolean,
    public val isFilled: Boolean,
    public val includesZero: Boolean,
    public val series: List<GraphSeries>,
) {
    /** The folder it belongs to; empty for the root folder. */
    public val folder: String get() = PathName.folderOf(name)

    /** The heading above the graph: its name without the folder, in `[ … ]` if [isVirtual]. */
    public val title: String get() = PathName.baseNameOf(name).let { if (isVirtual) "[ $it ]" else it }

    /** Whether the graph shows states rather than numbers: each of its series has [GraphSeries.states]. */
    public val showsStates: Boolean get() = series.all { it.states != null }
}
