package badlog.viewer.compare

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.text.BasicTextField
import androidx.compose.material3.LocalTextStyle
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.onFocusChanged
import androidx.compose.ui.graphics.SolidColor
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import badlog.viewer.text.exactText
import badlog.viewer.theme.LocalPalette
import java.math.BigDecimal
import java.math.RoundingMode

/** Says where the recording called [label] stands, and takes a number typed there; Enter or leaving the field moves it. */
@Composable
internal fun OffsetField(label: String, offset: Double, onMove: (Double) -> Unit) {
    val palette = LocalPalette.current
    // What is being typed; null while nothing is.
    var draft by remember(offset) { mutableStateOf<String?>(null) }
    val finish = {
        draft?.let(::offsetOf)?.let(onMove)
        draft = null
    }
    BasicTextField(
        draft ?: exactText(rounded(offset)),
        { draft = it },
        Modifier
            .width(88.dp)
            .background(palette.raised, RoundedCornerShape(4.dp))
            .border(1.dp, if (draft != null && offsetOf(draft) == null) palette.error else palette.border, RoundedCornerShape(4.dp))
            .padding(horizontal = 5.dp, vertical = 3.dp)
            .onFocusChanged { if (!it.isFocused) finish() }
            .onKeyEvent { event ->
                val isEnter = event.type == KeyEventType.KeyDown && (event.key == Key.Enter || event.key == Key.NumPadEnter)
                if (isEnter) finish()
                isEnter
            }
            .semantics { contentDescription = "Offset of $label" },
        textStyle = LocalTextStyle.current.copy(textAlign = TextAlign.End),
        singleLine = true,
        cursorBrush = SolidColor(palette.accent),
    )
}

/** The number that a person has typed, with a comma or a point; null for none. */
internal fun offsetOf(text: String?): Double? = text?.trim()?.replace(',', '.')?.toDoubleOrNull()?.takeIf { it.isFinite() }

/** [offset] without the dust of binary fractions that steps leave. */
internal fun rounded(offset: Double): Double =
    if (offset.isFinite()) BigDecimal(offset).setScale(DECIMALS, RoundingMode.HALF_EVEN).toDouble() else offset

private const val DECIMALS = 6
