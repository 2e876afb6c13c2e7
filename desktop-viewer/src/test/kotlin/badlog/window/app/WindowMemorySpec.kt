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

    test("a window reopens at its last place") {
        val state = windowStateOf(WindowPlace(1500, 40, 2000, 1200, isMaximized = true), listOf(laptop, monitor))
        state.position shouldBe WindowPosition(1500.dp, 40.dp)
        state.size shouldBe DpSize(2000.dp, 1200.dp)
        state.placement shouldBe WindowPlacement.Maximized
    }

    test("a window from a missing screen moves to the remaining one, and is not larger than it") {
        val state = windowStateOf(WindowPlace(1500, 40, 2000, 1200, isMaximized = false), listOf(laptop))
        state.position shouldBe WindowPosition(0.dp, 0.dp)
        state.size shouldBe DpSize(1366.dp, 768.dp)
        state.placement shouldBe WindowPlacement.Floating
    }

    test("the first window fills a small laptop, and is in the middle of a larger screen") {
        val small = windowStateOf(null, listOf(laptop))
        small.size shouldBe DpSize(1366.dp, 768.dp)
        small.position shouldBe WindowPosition(0.dp, 0.dp)
        small.placement shouldBe WindowPlacement.Maximized
        val large = windowStateOf(null, listOf(monitor))
        large.size shouldBe DpSize(1400.dp, 860.dp)
        large.position shouldBe WindowPosition((1366 + 580).dp, 290.dp)
        large.placement shouldBe WindowPlacement.Floating
    }

    test("a window beyond the edge of its screen reopens completely visible") {
        windowStateOf(WindowPlace(48, 48, 1366, 700, isMaximized = false), listOf(laptop)).position shouldBe WindowPosition(0.dp, 48.dp)
        windowStateOf(WindowPlace(1000, 400, 600, 500, isMaximized = false), listOf(laptop)).position shouldBe WindowPosition(766.dp, 268.dp)
    }

    test("a damaged size results in a window of the minimum size") {
        windowStateOf(WindowPlace(0, 0, -5, 0, isMaximized = false), listOf(laptop)).size shouldBe DpSize(320.dp, 240.dp)
    }
})
