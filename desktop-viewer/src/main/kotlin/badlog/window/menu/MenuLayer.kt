package badlog.window.menu

import androidx.compose.foundation.LocalContextMenuRepresentation
import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.focusGroup
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.IntrinsicSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.key
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.shadow
import androidx.compose.ui.focus.FocusDirection
import androidx.compose.ui.focus.FocusManager
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.input.pointer.PointerEventPass
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.layout.LayoutCoordinates
import androidx.compose.ui.layout.layout
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.layout.onPlaced
import androidx.compose.ui.layout.positionInRoot
import androidx.compose.ui.platform.LocalFocusManager
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.toSize
import badlog.viewer.input.MenuAnchor
import badlog.window.theme.LocalPalette
import kotlin.math.roundToInt

/**
 * Shows [content], and its open menus above it. The menus are in the window itself, because separate windows would consume the press
 * that closes them, which is meant for the element below it.
 */
@Composable
internal fun MenuLayer(menus: OpenMenus, content: @Composable () -> Unit) {
    var layer: LayoutCoordinates? = null
    CompositionLocalProvider(LocalOpenMenus provides menus, LocalContextMenuRepresentation provides ContextMenus) {
        Box(
            Modifier
                .onPlaced { layer = it }
                .pointerInput(menus) {
                    awaitPointerEventScope {
                        while (true) {
                            val event = awaitPointerEvent(PointerEventPass.Initial)
                            val corner = layer?.positionInRoot() ?: continue
                            if (event.type == PointerEventType.Press) menus.pressed(event.changes.first().position + corner)
                        }
                    }
                },
            propagateMinConstraints = true,
        ) {
            content()
            for (menu in menus.shown) key(menu) { MenuSheet(menu) { layer } }
        }
    }
}

@Composable
private fun MenuSheet(menu: OpenMenu, layer: () -> LayoutCoordinates?) {
    val palette = LocalPalette.current
    val focus = remember { FocusRequester() }
    val manager = LocalFocusManager.current
    val scroll = rememberScrollState()
    val shape = RoundedCornerShape(5.dp)
    if (menu.takesKeys) LaunchedEffect(menu) { focus.requestFocus() }
    Box(
        Modifier
            .layout { measurable, constraints ->
                val placeable = measurable.measure(Constraints(maxWidth = constraints.maxWidth, maxHeight = constraints.maxHeight))
                layout(constraints.maxWidth, constraints.maxHeight) {
                    val corner = layer()?.positionInRoot() ?: return@layout
                    val anchor = menu.anchor.translate(-corner)
                    val (x, y) = MenuAnchor(anchor.left, anchor.top, anchor.bottom)
                        .cornerOf(placeable.width, placeable.height, constraints.maxWidth, constraints.maxHeight)
                    placeable.place(x.roundToInt(), y.roundToInt())
                }
            }
            .onGloballyPositioned { menu.bounds = Rect(it.positionInRoot(), it.size.toSize()) }
            .shadow(6.dp, shape)
            .background(palette.raised, shape)
            .border(1.dp, palette.border, shape)
            // Elements below must not react to the pointer.
            .pointerInput(Unit) {}
            .focusRequester(focus)
            .focusProperties { if (!menu.takesKeys) onEnter = { cancelFocusChange() } }
            .focusGroup()
            .onKeyEvent { goesOn(it, manager) },
    ) {
        Column(Modifier.padding(vertical = 6.dp).width(IntrinsicSize.Max).verticalScroll(scroll)) { menu.content() }
        if (scroll.maxValue in 1..<Int.MAX_VALUE) {
            VerticalScrollbar(rememberScrollbarAdapter(scroll), Modifier.align(Alignment.CenterEnd).matchParentSize())
        }
    }
}

/** Handles the arrow keys, which move from line to line. */
private fun goesOn(event: KeyEvent, focus: FocusManager): Boolean {
    if (event.type != KeyEventType.KeyDown) return false
    return when (event.key) {
        Key.DirectionDown -> focus.moveFocus(FocusDirection.Next)
        Key.DirectionUp -> focus.moveFocus(FocusDirection.Previous)
        else -> false
    }
}
