package badlog.window.menu

import androidx.compose.foundation.ContextMenuArea
import androidx.compose.foundation.ContextMenuItem
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsFocused
import androidx.compose.ui.test.assertIsSelected
import androidx.compose.ui.test.click
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performScrollTo
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.requestFocus
import androidx.compose.ui.test.rightClick
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import androidx.compose.ui.test.withKeyDown
import androidx.compose.ui.unit.dp
import badlog.window.graph.savePicture
import badlog.window.theme.Icons
import badlog.window.theme.Theme
import badlog.window.theme.ToolButton
import badlog.window.theme.ViewerTheme
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import java.awt.event.KeyEvent

@OptIn(ExperimentalTestApi::class)
class OpenMenusSpec : FunSpec({
    val keyboard = Keyboard()

    /** Shows [content] in a window that receives keys like the real one. */
    @Composable
    fun TestWindow(content: @Composable () -> Unit) = ViewerTheme(Theme.LIGHT) {
        Box(Modifier.fillMaxSize().onPreviewKeyEvent { keyboard.dispatchFirst(it, emptyList()) }) { keyboard.Watch(content) }
    }

    test("Escape closes only the open menu, and its button gets the keyboard focus again") {
        runDesktopComposeUiTest(400, 300) {
            setContent { TestWindow { Box { Menu("Export", "Export menu", Icons.Graph) { listOf(MenuEntry("Save page") {}) } } } }
            keyboard.menus.closeLast() shouldBe false
            onNodeWithContentDescription("Export menu").requestFocus()
            onNodeWithContentDescription("Export menu").performKeyInput { pressKey(Key.Enter) }
            onNodeWithContentDescription("Save page").assertIsFocused()
            onNodeWithContentDescription("Save page").performKeyInput { pressKey(Key.Escape) }
            onNodeWithContentDescription("Save page").assertDoesNotExist()
            onNodeWithContentDescription("Export menu").assertIsFocused()
            runOnIdle { keyboard.menus.closeLast() shouldBe false }
        }
    }

    test("a click beside a menu closes it and has its own effect, also on another menu’s button; a click on its own button closes it") {
        val done = ArrayList<String>()
        runDesktopComposeUiTest(900, 300) {
            setContent {
                TestWindow {
                    Column(verticalArrangement = Arrangement.spacedBy(120.dp)) {
                        Menu("One", "First menu", Icons.Graph) { listOf(MenuEntry("Do one") { done += "one" }) }
                        ToolButton("Beside", text = "Beside") { done += "beside" }
                        Menu("Two", "Second menu", Icons.Graph) { listOf(MenuEntry("Do two") { done += "two" }) }
                    }
                }
            }
            onNodeWithContentDescription("First menu").performMouseInput { click() }
            onNodeWithContentDescription("Do one").assertExists()
            onNodeWithContentDescription("Beside").performMouseInput { click() }
            onNodeWithContentDescription("Do one").assertDoesNotExist()
            done shouldContainExactly listOf("beside")

            onNodeWithContentDescription("First menu").performMouseInput { click() }
            onNodeWithContentDescription("Second menu").performMouseInput { click() }
            onNodeWithContentDescription("Do one").assertDoesNotExist()
            onNodeWithContentDescription("Do two").performMouseInput { click() }
            onNodeWithContentDescription("Do two").assertDoesNotExist()
            done shouldContainExactly listOf("beside", "two")

            repeat(2) { onNodeWithContentDescription("First menu").performMouseInput { click() } }
            onNodeWithContentDescription("Do one").assertDoesNotExist()
        }
    }

    test("a context menu opens at the pointer, has all of its lines, and closes like other menus") {
        val done = ArrayList<String>()
        runDesktopComposeUiTest(400, 300) {
            setContent {
                TestWindow {
                    Column {
                        ContextMenuArea({ List(40) { ContextMenuItem("Line $it") { done += "$it" } } }) { Box(Modifier.testTag("area").size(100.dp)) }
                        ToolButton("Beside", text = "Beside") { done += "beside" }
                    }
                }
            }
            onNodeWithTag("area").performMouseInput { rightClick() }
            onNodeWithText("Line 39").performScrollTo().performMouseInput { click() }
            onNodeWithText("Line 0").assertDoesNotExist()
            onNodeWithTag("area").performMouseInput { rightClick(Offset(2f, 2f)) }
            onNodeWithText("Line 0").assertExists()
            runOnIdle { keyboard.menus.closeLast() shouldBe true }
            onNodeWithText("Line 0").assertDoesNotExist()
            done shouldContainExactly listOf("39")
        }
    }

    test("a context menu receives the arrow keys, Enter and Escape, while the focused element keeps the focus") {
        val done = ArrayList<String>()
        runDesktopComposeUiTest(400, 300) {
            setContent {
                TestWindow {
                    Column {
                        ContextArea({ List(40) { ContextMenuItem("Line $it") { done += "$it" } } }) { Box(Modifier.testTag("area").size(100.dp)) }
                        ToolButton("Beside", text = "Beside") { done += "beside" }
                    }
                }
            }
            val beside = onNodeWithContentDescription("Beside")
            beside.requestFocus()
            fun press(keys: List<Key>) = beside.performKeyInput { keys.forEach { pressKey(it) } }

            onNodeWithTag("area").performMouseInput { rightClick() }
            press(listOf(Key.Enter))
            done.shouldBeEmpty()
            press(listOf(Key.DirectionDown, Key.DirectionDown))
            onNodeWithText("Line 1").assertIsSelected()
            press(listOf(Key.Enter))
            onNodeWithText("Line 1").assertDoesNotExist()
            done shouldContainExactly listOf("1")

            onNodeWithTag("area").performMouseInput { rightClick() }
            press(listOf(Key.DirectionUp))
            onNodeWithText("Line 39").assertIsSelected().assertIsDisplayed()
            savePicture("context-menu-marked")
            press(listOf(Key.MoveHome, Key.DirectionUp, Key.DirectionDown, Key.MoveEnd, Key.Enter))
            done shouldContainExactly listOf("1", "39")

            onNodeWithTag("area").performMouseInput { rightClick() }
            press(listOf(Key.DirectionDown, Key.Escape))
            onNodeWithText("Line 0").assertDoesNotExist()
            beside.assertIsFocused()
            press(listOf(Key.Enter))
            done shouldContainExactly listOf("1", "39", "beside")
        }
    }

    test("the menu key and Shift+F10 open the menu of the focused element, with its first line marked") {
        val done = ArrayList<String>()
        runDesktopComposeUiTest(400, 300) {
            setContent {
                TestWindow {
                    Column {
                        ContextArea({ listOf(ContextMenuItem("Do one") { done += "one" }) }) { ToolButton("One", text = "One") {} }
                        ContextArea({ emptyList() }) { ToolButton("None", text = "None") {} }
                    }
                }
            }
            val one = onNodeWithContentDescription("One")
            one.requestFocus()
            one.performKeyInput { pressKey(Key.F10) }
            onNodeWithText("Do one").assertDoesNotExist()
            one.performKeyInput { withKeyDown(Key.ShiftLeft) { pressKey(Key.F10) } }
            onNodeWithText("Do one").assertIsSelected()
            one.performKeyInput { pressKey(Key.Enter) }
            one.performKeyInput { pressKey(Key(KeyEvent.VK_CONTEXT_MENU)) }
            onNodeWithText("Do one").assertIsSelected()
            one.performKeyInput { pressKey(Key.Escape) }
            onNodeWithText("Do one").assertDoesNotExist()
            one.assertIsFocused()
            done shouldContainExactly listOf("one")

            val none = onNodeWithContentDescription("None")
            none.requestFocus()
            none.performKeyInput { withKeyDown(Key.ShiftLeft) { pressKey(Key.F10) } }
            runOnIdle { keyboard.menus.closeLast() shouldBe false }
        }
    }
})
