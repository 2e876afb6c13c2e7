package badlog.window.waiting

import androidx.compose.runtime.snapshots.Snapshot
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import badlog.window.app.Viewer
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.swing.Swing
import kotlinx.coroutines.yield
import kotlin.time.Duration.Companion.seconds

/**
 * Waits until [condition] holds, and the window’s thread has finished its current work. That work may have changed only a part of the
 * state. Compose's own wait ends after a second, which a busy machine exceeds.
 */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.waitFor(condition: () -> Boolean) {
    waitUntil(timeoutMillis = 60_000, condition = condition)
    runOnUiThread { }
}

/** Waits until a notice of [viewer] contains [text]. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.waitForNotice(viewer: Viewer, text: String) = waitFor { viewer.notices.all.any { text in it.text } }

/** Runs [steps] on the window’s thread, without a window. */
internal fun onWindowThread(steps: suspend CoroutineScope.() -> Unit) = runBlocking(Dispatchers.Swing) { steps() }

/** Waits until [condition] holds. Announces changes of the state, as a window does by itself. */
internal suspend fun awaitState(condition: () -> Boolean) = eventually(60.seconds) {
    Snapshot.sendApplyNotifications()
    condition() shouldBe true
}

/** Waits until [viewer] shows all choices, and its observers have handled the last change. */
internal suspend fun awaitShown(viewer: Viewer) {
    awaitState { !viewer.shown.isWaiting && viewer.tasks.all.isEmpty() }
    repeat(TURNS) {
        Snapshot.sendApplyNotifications()
        yield()
    }
}

/** The turns of the window’s thread to wait for; a change needs fewer to reach all observers. */
private const val TURNS = 20
