package badlog.viewer

import androidx.compose.runtime.Composable
import badlog.viewer.app.Viewer
import badlog.viewer.inspector.InspectorPane
import badlog.viewer.topic.TopicPane

/** The panel at the right of [viewer]. */
@Composable
internal fun TestInspector(viewer: Viewer) = with(viewer) { InspectorPane(current, compared, board, view, events, findings, notes, video, panels) }

/** The topics of [viewer]. */
@Composable
internal fun TestTopics(viewer: Viewer) = with(viewer) { TopicPane(current, compared, board, view, events, formulas, topics, panels) }
