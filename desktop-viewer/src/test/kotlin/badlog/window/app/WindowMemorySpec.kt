package badlog.window.app

import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import androidx.compose.ui.window.WindowPlacement
import androidx.compose.ui.window.WindowPosition
import badlog.window.settings.WindowPlace
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.awt.Rectangle

class WindowMemorySpec : FunSpec({
    val laptop = Rectangle(0, 0, 1366, 768)
    val monitor = Rectangle(1366, 0, 2560, 1440)

    test("a window comes back to where it was") {
        val state = windowStateOf(WindowPlace(1500, 40, 2000, 1200, isMaximized = true), listOf(laptop, monitor))
        state.position shouldBe WindowPosition(1500.dp, 40.dp)
        state.size shouldBe DpSize(2000.dp, 1200.dp)
        state.placement shouldBe WindowPlacement.Maximized
    }

    test("a window whose screen is gone comes to the one that is there, no larger than that") {
        val state = windowStateOf(WindowPlace(1500, 40, 2000, 1200, isMaximized = false), listOf(laptop))
        state.position shouldBe WindowPosition.PlatformDefault
        state.size shouldBe DpSize(1366.dp, 768.dp)
    }

    test("the first window fits a small laptop") {
        windowStateOf(null, listOf(laptop)).size shouldBe DpSize(1366.dp, 768.dp)
        windowStateOf(null, listOf(monitor)).size shouldBe DpSize(1400.dp, 860.dp)
    }

    test("a damaged size still gives a window that can be taken hold of") {
        windowStateOf(WindowPlace(0, 0, -5, 0, isMaximized = false), listOf(laptop)).size shouldBe DpSize(320.dp, 240.dp)
    }
})
