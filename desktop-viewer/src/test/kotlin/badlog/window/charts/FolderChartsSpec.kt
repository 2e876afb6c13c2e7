package badlog.window.charts

import badlog.catalog.folder.LogEntry
import badlog.catalog.folder.putSamples
import badlog.files.UserFolders
import badlog.window.app.Viewer
import badlog.window.files.ChosenFiles
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.cancelAndJoin
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import kotlinx.coroutines.withTimeout
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.minutes

/** When charts of a folder’s logs are drawn, whatever shows them. */
class FolderChartsSpec : FunSpec({
    suspend fun until(condition: () -> Boolean) = withTimeout(3.minutes) { while (!condition()) delay(5.milliseconds) }

    /** Does [steps] with the sorted logs of a folder of samples, and with what makes charts of a list of them. */
    suspend fun following(steps: suspend (FolderCharts, List<LogEntry>, MutableStateFlow<List<LogEntry>>) -> Unit) = withContext(Dispatchers.Main) {
        val home = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(home, home), files = ChosenFiles(null))
        viewer.library.open(tempdir().toPath().also { it.putSamples() }, showsNewest = false)
        until { viewer.library.state.run { hasLooked && entries.isNotEmpty() && entries.all { it.isGray || it.found != null } } }
        val lists = MutableStateFlow(emptyList<LogEntry>())
        val following = launch { viewer.charts.follow(lists) }
        try {
            steps(viewer.charts, viewer.library.state.entries.filter { it.isReadable && !it.isGray }.sortedBy { it.path }, lists)
        } finally {
            following.cancelAndJoin()
            viewer.library.close()
        }
    }

    test("a list that grows does not stop the drawing that runs; its own charts follow") {
        following { charts, logs, lists ->
            val more = logs + logs
            lists.value = logs
            until { charts.state.isDrawing }
            lists.value = more
            until { charts.state.of == logs }
            until { charts.state.of == more }
            charts.state.asked shouldBe more
        }
    }

    test("a list that is never calm has charts all the same") {
        following { charts, logs, lists ->
            var change = 0
            until {
                // The rules look into one log after the other.
                lists.value = logs.map { it.copy(found = it.found!!.copy(key = change)) }
                change++
                charts.state.charts != null
            }
            change shouldBeGreaterThan 3
        }
    }

    test("charts that are right again while others are being drawn are not called stopped") {
        following { charts, logs, lists ->
            lists.value = logs
            until { charts.state.of == logs }
            val drawn = charts.state.charts
            lists.value = logs + logs
            until { charts.state.isDrawing }
            lists.value = logs
            until { !charts.state.isDrawing }
            charts.state.run { listOf(this.charts === drawn, of == logs, isStopped) } shouldBe listOf(true, true, false)
        }
    }

    test("charts are not shown as those of a folder that shares no log with them") {
        following { charts, logs, lists ->
            lists.value = logs.take(1)
            until { charts.state.of.isNotEmpty() }
            charts.state.run { listOf(chartsFor(logs) === this.charts, chartsFor(logs.drop(1)), chartsFor(emptyList())) } shouldBe listOf(true, null, null)
        }
    }

    test("logs over which the rules of today were not run are counted") {
        following { _, logs, _ -> drawCharts(logs, { null }) {}.unknown shouldBe logs.size }
    }
})
