package badlog.viewer.inspector

import androidx.compose.ui.graphics.vector.ImageVector
import badlog.viewer.app.InspectorTab
import badlog.viewer.theme.Icons

/** What the window calls the panel. */
internal val InspectorTab.title: String
    get() = when (this) {
        InspectorTab.EVENTS -> "Events"
        InspectorTab.VALUES -> "Values"
        InspectorTab.PROBLEMS -> "Problems"
        InspectorTab.STATISTICS -> "Statistics"
        InspectorTab.FINDINGS -> "Findings"
    }

/** What stands for it on a button. */
internal val InspectorTab.icon: ImageVector
    get() = when (this) {
        InspectorTab.EVENTS -> Icons.Flag
        InspectorTab.VALUES -> Icons.Info
        InspectorTab.PROBLEMS -> Icons.Warning
        InspectorTab.STATISTICS -> Icons.Sigma
        InspectorTab.FINDINGS -> Icons.Diamond
    }
