package badlog.window.findings

import androidx.compose.runtime.snapshots.Snapshot
import badlog.core.analysis.LogView
import badlog.files.UserFolders
import badlog.viewer.shown.finding.RuleResults
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.sidebar.MainView
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.cancel
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import java.nio.file.Path
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

class CurrentFindingsSpec : FunSpec({
    val home = tempdir().toPath()

    /** Returns a window without graphs, for which the rules do not wait. */
    fun viewerIn(scope: CoroutineScope) = Viewer(scope, UserFolders(home, home)).apply { panels.change { copy(main = MainView.LOGS) } }

    /** Returns the findings of [viewer], as returned by [find]. */
    fun findingsBy(viewer: Viewer, rest: suspend () -> Unit = {}, find: (LogView, Path, Path?) -> RuleResults) = CurrentFindings(viewer.current, viewer.view, viewer.board, { null }, {}, rest = { rest() }, find)

    suspend fun over(test: suspend (Viewer) -> Unit) {
        val scope = CoroutineScope(Dispatchers.Main + Job())
        try {
            test(viewerIn(scope))
        } finally {
            scope.cancel()
        }
    }

    // Observers of the state are notified when a frame is drawn, which does not happen here.
    suspend fun change(change: () -> Unit) = withContext(Dispatchers.Main) {
        change()
        Snapshot.sendApplyNotifications()
    }

    test("the rules run over each opened log, and again on request") {
        val folder = tempdir().toPath()
        writeRules(folder, ruleText("Half", "A > 50"))
        over { viewer ->
            viewer.scope.launch { viewer.findings.run() }
            change { viewer.current.replace(counted(folder)) }
            eventually(60.seconds) { viewer.findings.state.list?.all?.map { it.rule } shouldBe listOf("Half") }
            writeRules(folder, ruleText("Other", "A > 70"))
            change { viewer.findings.runAgain() }
            eventually(60.seconds) { viewer.findings.state.list?.all?.map { it.rule } shouldBe listOf("Other") }
        }
    }

    test("a log that grows all the time is examined at intervals, including its last state") {
        val folder = tempdir().toPath()
        val runs = AtomicInteger()
        val rests = Channel<Unit>()
        over { viewer ->
            val findings = findingsBy(viewer, rest = { rests.receive() }) { view, _, _ ->
                runs.incrementAndGet()
                RuleResults(trouble = "${view.recording.rowCount} rows")
            }
            viewer.scope.launch { findings.run() }
            change { viewer.current.replace(counted(folder, rows = 1)) }
            eventually(60.seconds) { findings.state.list?.trouble shouldBe "1 rows" }
            for (rows in 2..20) change { viewer.current.replace(counted(folder, rows)) }
            rests.send(Unit)
            eventually(60.seconds) { findings.state.list?.trouble shouldBe "20 rows" }
            runs.get() shouldBe 2
        }
        pauseAfter(Duration.ZERO) shouldBe 2.seconds
        pauseAfter(1.seconds) shouldBe 9.seconds
    }

    test("the worst finding of a log being opened is shown once it is known, unless another log is opened") {
        val folder = tempdir().toPath()
        writeRules(folder, ruleText("Note", "A > 10", "note"), ruleText("Error", "A > 50", "error"))
        val wanted = counted(folder)
        over { viewer ->
            viewer.scope.launch { viewer.findings.run() }
            change { viewer.findings.showWorst(wanted.file) }
            change { viewer.current.replace(wanted) }
            eventually(60.seconds) { viewer.findings.selected?.rule shouldBe "Error" }
            change { viewer.view.send(PlaceAction.Visit(null)) }
            change { viewer.findings.showWorst(wanted.file) }
            viewer.findings.selected?.rule shouldBe "Error"

            change { viewer.findings.showWorst(folder.resolve("never opened.bag")) }
            change { viewer.current.replace(counted(home)) }
            // The findings of the previous log stay until the window receives the other one.
            eventually(60.seconds) { viewer.findings.state.list?.all?.none { it.rule == "Error" } shouldBe true }
            viewer.findings.selected shouldBe null
        }
    }

    test("opening another recording cancels the running rules") {
        val began = CountDownLatch(1)
        val interrupted = CountDownLatch(1)
        over { viewer ->
            val findings = findingsBy(viewer) { _, file, _ ->
                if (file.endsWith("slow/counted.bag")) {
                    began.countDown()
                    try {
                        CountDownLatch(1).await()
                    } catch (e: InterruptedException) {
                        interrupted.countDown()
                        throw e
                    }
                }
                RuleResults(trouble = "quick")
            }
            viewer.scope.launch { findings.run() }
            change { viewer.current.replace(counted(home.resolve("slow"))) }
            began.await(60, TimeUnit.SECONDS) shouldBe true
            change { viewer.current.replace(counted(home.resolve("other"))) }
            interrupted.await(60, TimeUnit.SECONDS) shouldBe true
            eventually(60.seconds) { findings.state.list?.trouble shouldBe "quick" }
        }
    }
})
