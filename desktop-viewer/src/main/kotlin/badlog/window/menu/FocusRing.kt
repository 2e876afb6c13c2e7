package badlog.window.menu

import androidx.compose.foundation.IndicationNodeFactory
import androidx.compose.foundation.interaction.FocusInteraction
import androidx.compose.foundation.interaction.InteractionSource
import androidx.compose.foundation.interaction.PressInteraction
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.drawscope.ContentDrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.node.CompositionLocalConsumerModifierNode
import androidx.compose.ui.node.DelegatableNode
import androidx.compose.ui.node.DrawModifierNode
import androidx.compose.ui.node.currentValueOf
import badlog.window.theme.LocalPalette
import kotlinx.coroutines.launch

/**
 * Frames the focused element if a person navigates by keys, see [Keyboard.showsFocus], and shades a pressed one. Material's own focus
 * indication is hardly visible.
 */
internal class FocusRing(private val keyboard: Keyboard) : IndicationNodeFactory {
    override fun create(interactionSource: InteractionSource): DelegatableNode = Ring(keyboard, interactionSource)

    override fun equals(other: Any?): Boolean = other is FocusRing && other.keyboard === keyboard

    override fun hashCode(): Int = keyboard.hashCode()

    private class Ring(private val keyboard: Keyboard, private val source: InteractionSource) :
        Modifier.Node(),
        DrawModifierNode,
        CompositionLocalConsumerModifierNode {
        private var isFocused by mutableStateOf(false)
        private var isPressed by mutableStateOf(false)

        override fun onAttach() {
            coroutineScope.launch {
                source.interactions.collect { interaction ->
                    when (interaction) {
                        is FocusInteraction.Focus -> isFocused = true
                        is FocusInteraction.Unfocus -> isFocused = false
                        is PressInteraction.Press -> isPressed = true
                        is PressInteraction.Release, is PressInteraction.Cancel -> isPressed = false
                    }
                }
            }
        }

        override fun ContentDrawScope.draw() {
            drawContent()
            val palette = currentValueOf(LocalPalette)
            if (isPressed) drawRect(palette.text.copy(alpha = PRESSED))
            if (!isFocused || !keyboard.showsFocus) return
            val line = WIDTH * density
            drawRoundRect(
                palette.accent,
                Offset(line / 2, line / 2),
                Size(size.width - line, size.height - line),
                CornerRadius(CORNER * density),
                Stroke(line),
            )
        }
    }

    private companion object {
        const val WIDTH = 2f
        const val CORNER = 4f
        const val PRESSED = 0.08f
    }
}
