package badlog.window.menu

import androidx.compose.foundation.ContextMenuArea
import androidx.compose.foundation.ContextMenuItem
import androidx.compose.foundation.ContextMenuRepresentation
import androidx.compose.foundation.ContextMenuState
import androidx.compose.foundation.LocalContextMenuRepresentation
import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.focusGroup
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.IntrinsicSize
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.SideEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.key
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.neverEqualPolicy
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.shadow
import androidx.compose.ui.focus.FocusDirection
import androidx.compose.ui.focus.FocusManager
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isShiftPressed
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
import androidx.compose.ui.layout.onSizeChanged
import androidx.compose.ui.layout.positionInRoot
import androidx.compose.ui.platform.LocalFocusManager
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.IntSize
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.toSize
import badlog.viewer.input.MenuAnchor
import badlog.window.theme.LocalPalette
import java.awt.event.KeyEvent.VK_CONTEXT_MENU
import kotlin.math.roundToInt

/**
 * Context menus that look like all other menus of the window. The clicked element keeps the keyboard focus, as it may be a field; the menu
 * receives the keys before that element does.
 */
internal object ContextMenus : ContextMenuRepresentation {
    @Composable
    override fun Representation(state: ContextMenuState, items: () -> List<ContextMenuItem>) {
        val status = state.status as? ContextMenuState.Status.Open ?: return
        var place: LayoutCoordinates? by remember { mutableStateOf(null, neverEqualPolicy()) }
        Spacer(Modifier.onGloballyPositioned { place = it })
        val area = place?.takeIf { it.isAttached } ?: return
        fun close() {
            state.status = ContextMenuState.Status.Closed
        }
        // A right click elsewhere in the same area opens the menu again.
        key(status) {
            val isOfKeys = !status.rect.isEmpty
            val lines = items()
            var marked by remember { mutableIntStateOf(if (isOfKeys) 0 else NONE) }

            fun run(line: ContextMenuItem) {
                close()
                line.onClick()
            }

            fun handle(key: Key): Boolean {
                if (lines.isEmpty()) return false
                when (key) {
                    Key.DirectionDown -> marked = (marked + 1) % lines.size
                    Key.DirectionUp -> marked = (if (marked <= 0) lines.size else marked) - 1
                    Key.MoveHome -> marked = 0
                    Key.MoveEnd -> marked = lines.lastIndex
                    Key.Enter, Key.NumPadEnter -> lines.getOrNull(marked)?.let(::run)
                    else -> return false
                }
                return true
            }

            // A menu that keys opened is below its area, which would be covered otherwise.
            val corner = if (isOfKeys) status.rect.bottomLeft else status.rect.center
            ShowMenu(Rect(area.localToRoot(corner), Size.Zero), takesKeys = false, ::close, onClosed = {}, onKey = ::handle) {
                lines.forEachIndexed { i, line -> MenuLine(line.label, isMarked = i == marked) { run(line) } }
            }
        }
    }

    /** No line is marked yet. */
    private const val NONE = -1
}

/**
 * [content] with a context menu of [items]. The right button opens it. The menu key or Shift+F10 open it while something in [content] has
 * the keyboard focus.
 */
@Composable
internal fun ContextArea(items: () -> List<ContextMenuItem>, content: @Composable () -> Unit) {
    val state = remember { ContextMenuState() }
    var size by remember { mutableStateOf(IntSize.Zero) }
    ContextMenuArea(items, state) {
        Box(
            Modifier
                .onSizeChanged { size = it }
                .onKeyEvent { event ->
                    val opens = opensMenu(event) && items().isNotEmpty()
                    if (opens) state.status = ContextMenuState.Status.Open(Rect(Offset.Zero, size.toSize()))
                    opens
                },
            propagateMinConstraints = true,
        ) { content() }
    }
}

private fun opensMenu(event: KeyEvent): Boolean =
    event.type == KeyEventType.KeyDown && (event.key == MENU_KEY || (event.key == Key.F10 && event.isShiftPressed))

private val MENU_KEY = Key(VK_CONTEXT_MENU)

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

/**
 * [opener], usually a button, with the content of [menu] below it while [isOpen]. Escape and a press elsewhere call [onClose]; the press
 * still has its usual effect. The menu has the keyboard focus while it is open; afterwards [opener] gets it back.
 */
@Composable
internal fun MenuBox(
    isOpen: Boolean,
    onClose: () -> Unit,
    modifier: Modifier = Modifier,
    menu: @Composable () -> Unit,
    opener: @Composable () -> Unit,
) {
    val focus = remember { FocusRequester() }
    var place: LayoutCoordinates? by remember { mutableStateOf(null, neverEqualPolicy()) }
    Box(modifier.onGloballyPositioned { place = it }.focusRequester(focus).focusGroup()) { opener() }
    if (isOpen) {
        val anchor = place?.takeIf { it.isAttached }?.let { Rect(it.positionInRoot(), it.size.toSize()) } ?: Rect.Zero
        ShowMenu(anchor, takesKeys = true, onClose, { if (place?.isAttached == true) focus.requestFocus() }, content = menu)
    }
}

/**
 * Makes the [MenuLayer] show [content] beside [anchor], a place in the window, while this is composed.
 *
 * @param onClosed called when that ends, but not if a press elsewhere closed it.
 * @param onKey called with each key that is pressed, before the focused element gets it; returns whether the menu used it.
 */
@Composable
internal fun ShowMenu(
    anchor: Rect,
    takesKeys: Boolean,
    onClose: () -> Unit,
    onClosed: () -> Unit,
    onKey: (Key) -> Boolean = { false },
    content: @Composable () -> Unit,
) {
    ClosesByEscape(isOpen = true, onClose)
    val menus = LocalOpenMenus.current
    val latest by rememberUpdatedState(content)
    val close by rememberUpdatedState(onClose)
    val closed by rememberUpdatedState(onClosed)
    val handle by rememberUpdatedState(onKey)
    val shown = remember { OpenMenu(takesKeys, { close() }, { handle(it) }) { latest() } }
    SideEffect { shown.anchor = anchor }
    DisposableEffect(menus) {
        menus.shown += shown
        onDispose {
            menus.shown -= shown
            if (!shown.wasLeft) closed()
        }
    }
}
