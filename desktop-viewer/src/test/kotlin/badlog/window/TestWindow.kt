package badlog.window

import androidx.compose.runtime.Composable
import badlog.window.app.Viewer
import badlog.window.sidebar.InspectorPane
import badlog.window.topics.TopicPane

/** The panel at the right of [viewer]. */
@Composable
internal fun TestInspector(viewer: Viewer) = with(viewer) { InspectorPane(current, compared, board, view, events, findings, since, notes, video, todo, panels, store::send) }

/** The topics of [viewer]. */
@Composable
internal fun TestTopics(viewer: Viewer) = with(viewer) { TopicPane(current, compared, board, view, events, formulas, topics, panels) }
