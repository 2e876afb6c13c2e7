package badlog.window.menu

import androidx.compose.foundation.clickable
import androidx.compose.foundation.focusable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.text.BasicTextField
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsFocused
import androidx.compose.ui.test.click
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.requestFocus
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import androidx.compose.ui.test.withKeyDown
import androidx.compose.ui.unit.dp
import badlog.files.UserFolders
import badlog.window.app.GESTURES
import badlog.window.app.Viewer
import badlog.window.app.ViewerScreen
import badlog.window.theme.SearchField
import badlog.window.theme.Theme
import badlog.window.theme.ViewerTheme
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope

@OptIn(ExperimentalTestApi::class)
class KeyboardSpec : FunSpec({
    test("keys run their commands, but letters go to the field in use") {
        val done = ArrayList<String>()
        val commands = listOf(
            Command("", "", listOf(KeyPress(Key.T, "T"))) { done += "T" },
            Command("", "", listOf(KeyPress(Key.T, "T", shift = true))) { done += "Shift+T" },
            Command("", "", listOf(KeyPress(Key.S, "S", ctrl = true))) { done += "Ctrl+S" },
            Command("", "", listOf(KeyPress(Key.Escape, "Esc"))) { done += "Esc" },
        )
        val keyboard = Keyboard()
        runDesktopComposeUiTest(300, 300) {
            setContent {
                keyboard.Watch {
                    Column(Modifier.onKeyEvent { keyboard.dispatch(it, commands) }) {
                        BasicTextField("", {}, Modifier.testTag("field"))
                        Box(Modifier.testTag("elsewhere").focusable())
                    }
                }
            }
            fun press(tag: String) = onNodeWithTag(tag).performKeyInput {
                pressKey(Key.T)
                withKeyDown(Key.ShiftLeft) { pressKey(Key.T) }
                withKeyDown(Key.CtrlLeft) { pressKey(Key.S) }
                pressKey(Key.Escape)
            }
            onNodeWithTag("elsewhere").requestFocus()
            press("elsewhere")
            done shouldContainExactly listOf("T", "Shift+T", "Ctrl+S", "Esc")
            done.clear()
            onNodeWithTag("field").requestFocus()
            waitForIdle()
            keyboard.isTyping shouldBe true
            press("field")
            done shouldContainExactly listOf("Ctrl+S", "Esc")
            done.clear()
            onNodeWithTag("elsewhere").requestFocus()
            waitForIdle()
            press("elsewhere")
            done shouldContainExactly listOf("T", "Shift+T", "Ctrl+S", "Esc")
        }
    }

    test("Space runs its command after a click on a button, Enter presses the button, and a field takes both") {
        val done = ArrayList<String>()
        val commands = listOf(Command("", "", listOf(KeyPress(Key.Spacebar, "Space"))) { done += "Space" })
        val keyboard = Keyboard()
        runDesktopComposeUiTest(300, 300) {
            setContent {
                keyboard.Watch {
                    Column(
                        Modifier
                            .onPreviewKeyEvent { keyboard.dispatchFirst(it, commands) }
                            .onKeyEvent { keyboard.dispatch(it, commands) },
                    ) {
                        BasicTextField("", {}, Modifier.testTag("field"))
                        Box(Modifier.testTag("button").size(20.dp).clickable { done += "button" })
                    }
                }
            }
            onNodeWithTag("button").performClick()
            onNodeWithTag("button").requestFocus()
            onNodeWithTag("button").performKeyInput {
                pressKey(Key.Spacebar)
                pressKey(Key.Enter)
            }
            done shouldContainExactly listOf("button", "Space", "button")
            onNodeWithTag("field").requestFocus()
            waitForIdle()
            onNodeWithTag("field").performKeyInput { pressKey(Key.Spacebar) }
            done.size shouldBe 3
        }
    }

    test("the help sheet lists every command and gesture, and closes") {
        val home = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        runDesktopComposeUiTest(1200, 800) {
            setContent { ViewerScreen(viewer) }
            viewer.commands.first { command -> command.keys.any { it.text == "F1" } }.action()
            for (command in viewer.commands) onNodeWithText(command.meaning).assertExists()
            for (gesture in GESTURES) onNodeWithText(gesture.meaning).assertExists()
            onNodeWithContentDescription("Close the sheet").performClick()
            runOnIdle { viewer.panels.state.help shouldBe false }
        }
    }

    test("a click at either edge of a search field gives it the keyboard focus") {
        var text by mutableStateOf("")
        runDesktopComposeUiTest(400, 100) {
            setContent { ViewerTheme(Theme.LIGHT) { SearchField(text, "Search topics", Modifier.width(300.dp)) { text = it } } }
            val field = onNodeWithContentDescription("Search topics")
            for (share in listOf(0.02f, 0.98f)) {
                field.performMouseInput { click(Offset(width * share, height / 2f)) }
                field.assertIsFocused()
            }
            field.performTextInput("arm")
            runOnIdle { text shouldBe "arm" }
        }
    }
})
