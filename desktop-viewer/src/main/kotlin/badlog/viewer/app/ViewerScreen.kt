package badlog.viewer.app

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.width
import androidx.compose.material3.VerticalDivider
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.viewer.compare.CompareBar
import badlog.viewer.formula.FormulaDialog
import badlog.viewer.graph.GraphPane
import badlog.viewer.inspector.InspectorPane
import badlog.viewer.library.LibraryPane
import badlog.viewer.library.LogTable
import badlog.viewer.panels.FrontPart
import badlog.viewer.panels.MainView
import badlog.viewer.statistics.StatisticsTable
import badlog.viewer.task.StatusBar
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.ViewerTheme
import badlog.viewer.topic.TopicPane

/** All of the window's content. */
@Composable
internal fun ViewerScreen(viewer: Viewer) {
    ViewerTheme(viewer.settings.theme) {
        viewer.keyboard.Watch {
            BoxWithConstraints(Modifier.fillMaxSize().acceptsFiles { viewer.openNamed(it) }) {
                val isNarrow = maxWidth < NARROW
                Column(Modifier.fillMaxSize().background(LocalPalette.current.page)) {
                    TopBar(viewer, isNarrow)
                    Box(Modifier.weight(1f).fillMaxWidth()) {
                        if (isNarrow) NarrowBody(viewer) else WideBody(viewer)
                        viewer.formulaSheet?.let { FormulaDialog(viewer, it, Modifier.align(Alignment.TopCenter)) }
                        if (viewer.panels.help) {
                            HelpSheet(viewer.commands.map { it.help } + GESTURES, Modifier.align(Alignment.TopCenter)) {
                                viewer.panels = viewer.panels.copy(help = false)
                            }
                        }
                    }
                    StatusBar(viewer)
                    if (isNarrow) FrontTabs(viewer)
                }
            }
        }
    }
}

@Composable
private fun WideBody(viewer: Viewer) {
    val panels = viewer.panels
    Row(Modifier.fillMaxSize()) {
        if (panels.library && panels.main != MainView.LOGS) {
            LibraryPane(viewer, Modifier.width(280.dp).fillMaxHeight())
            VerticalDivider()
        }
        if (panels.topics && panels.main == MainView.GRAPHS) {
            TopicPane(viewer, Modifier.width(240.dp).fillMaxHeight())
            VerticalDivider()
        }
        MainPart(viewer, Modifier.weight(1f).fillMaxHeight())
        if (panels.inspector != null && panels.main == MainView.GRAPHS) {
            VerticalDivider()
            InspectorPane(viewer, Modifier.width(320.dp).fillMaxHeight())
        }
    }
}

/** One part at a time, where there is no room for more. */
@Composable
private fun NarrowBody(viewer: Viewer) {
    val panels = viewer.panels
    val all = Modifier.fillMaxSize()
    if (panels.main != MainView.GRAPHS) return MainPart(viewer, all)
    when (panels.front) {
        FrontPart.LOGS -> LibraryPane(viewer, all)
        FrontPart.TOPICS -> TopicPane(viewer, all)
        FrontPart.GRAPHS -> MainPart(viewer, all)
        FrontPart.DETAILS -> InspectorPane(viewer, all)
    }
}

@Composable
private fun MainPart(viewer: Viewer, modifier: Modifier) {
    Box(modifier) {
        when (viewer.panels.main) {
            MainView.GRAPHS -> Column(Modifier.fillMaxSize()) {
                CompareBar(viewer)
                GraphPane(viewer, Modifier.weight(1f).fillMaxWidth())
            }

            MainView.LOGS -> LogTable(viewer, Modifier.fillMaxSize())

            MainView.STATISTICS -> StatisticsTable(viewer, Modifier.fillMaxSize())
        }
    }
}

private val NARROW = 720.dp
