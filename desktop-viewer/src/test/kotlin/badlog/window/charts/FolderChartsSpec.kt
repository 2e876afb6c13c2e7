package badlog.window.charts

import badlog.catalog.folder.LogEntry
import badlog.catalog.folder.entry
import badlog.files.UserFolders
import badlog.viewer.catalog.FindingSummary
import badlog.window.app.Viewer
import badlog.window.files.ChosenFiles
import badlog.window.task.LongTasks
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.cancelAndJoin
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import kotlinx.coroutines.yield
import java.util.concurrent.Semaphore
import kotlin.time.Duration.Companion.seconds

/** The times at which charts of a folder’s logs are drawn, whatever shows them and whatever they are. */
@Tags("InCheck")
class FolderChartsSpec : FunSpec({
    val logs = listOf("a.bag", "b.bag", "c.bag").map { entry(it).copy(found = FindingSummary(0, emptyList())) }
    val some = logs.take(2)

    suspend fun until(condition: () -> Boolean) = eventually(60.seconds) { condition() shouldBe true }

    var tasks: LongTasks? = null

    /** Runs [steps] with the charts, the list of logs, and permits; each permit lets one drawing end. */
    suspend fun following(steps: suspend (FolderCharts, MutableStateFlow<List<LogEntry>>, Semaphore) -> Unit) = withContext(Dispatchers.Main) {
        val home = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        val permits = Semaphore(0)
        tasks = viewer.tasks
        val charts = FolderCharts(viewer.scope, viewer.library, ChosenFiles(null), viewer.tasks, viewer.notices) { _, _, _ ->
            permits.acquire()
            DrawnCharts(emptyList(), emptyList())
        }
        val lists = MutableStateFlow(emptyList<LogEntry>())
        val following = launch { charts.follow(lists) }
        try {
            steps(charts, lists, permits)
        } finally {
            following.cancelAndJoin()
        }
    }

    test("a growing list does not stop a drawing; its own charts follow") {
        following { charts, lists, permits ->
            lists.value = some
            until { charts.state.isDrawing }
            lists.value = logs
            // The other list arrives while the first one is being drawn.
            repeat(20) { yield() }
            permits.release()
            until { charts.state.of == some }
            permits.release()
            until { charts.state.of == logs }
            charts.state.asked shouldBe logs
        }
    }

    test("a stopped drawing is reported, and can be restarted") {
        following { charts, lists, permits ->
            lists.value = logs
            until { charts.state.isDrawing && tasks!!.all.isNotEmpty() }
            tasks!!.all.forEach { it.cancel() }
            permits.release()
            until { charts.state.isStopped }
            charts.draw(logs)
            permits.release()
            until { charts.state.of == logs }
            charts.state.isStopped shouldBe false
        }
    }

    test("a list that never stops changing has charts, too") {
        following { charts, lists, permits ->
            permits.release()
            var change = 0
            until {
                // The rules examine one log after the other.
                lists.value = logs.map { it.copy(found = FindingSummary(change, emptyList())) }
                change++
                charts.state.charts != null
            }
            change shouldBeGreaterThan 3
        }
    }

    test("charts that are correct again during another drawing are not reported as stopped") {
        following { charts, lists, permits ->
            permits.release()
            lists.value = some
            until { charts.state.of == some }
            val drawn = charts.state.charts
            lists.value = logs
            until { charts.state.isDrawing }
            lists.value = some
            until { !charts.state.isDrawing }
            charts.state.run { listOf(this.charts === drawn, of == some, isStopped) } shouldBe listOf(true, true, false)
        }
    }

    test("charts are not shown for a folder that shares no log with them") {
        following { charts, lists, permits ->
            permits.release()
            lists.value = logs.take(1)
            until { charts.state.of.isNotEmpty() }
            charts.state.run { listOf(chartsFor(logs) === this.charts, chartsFor(logs.drop(1)), chartsFor(emptyList())) } shouldBe listOf(true, null, null)
        }
    }

    test("logs without results of today's rules are counted") {
        drawCharts(logs, { null }) {}.unknown shouldBe logs.size
    }
})
