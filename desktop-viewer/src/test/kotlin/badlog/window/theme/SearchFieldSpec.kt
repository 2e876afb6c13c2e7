package badlog.window.theme

import androidx.compose.foundation.layout.width
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsFocused
import androidx.compose.ui.test.click
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import androidx.compose.ui.unit.dp
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

@OptIn(ExperimentalTestApi::class)
class SearchFieldSpec : FunSpec({
    for (share in listOf(0.02f, 0.5f, 0.98f)) {
        test("a click at $share of its width gives the field the keyboard focus") {
            var text by mutableStateOf("")
            runDesktopComposeUiTest(400, 100) {
                setContent { ViewerTheme(Theme.LIGHT) { SearchField(text, "Search topics", Modifier.width(300.dp)) { text = it } } }
                val field = onNodeWithContentDescription("Search topics")
                field.performMouseInput { click(Offset(width * share, height / 2f)) }
                field.assertIsFocused()
                field.performTextInput("arm")
                runOnIdle { text shouldBe "arm" }
            }
        }
    }
})
