package badlog.window.theme

import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.snapshots.Snapshot

/** Scrolls [list] until the item [key], at [index], is visible, whenever another item becomes it; not when its index changes. */
@Composable
internal fun KeepInSight(list: LazyListState, key: Any?, index: Int) {
    LaunchedEffect(key) {
        if (index < 0) return@LaunchedEffect
        val layout = list.layoutInfo
        val item = layout.visibleItemsInfo.firstOrNull { it.index == index }
        when {
            item == null -> if (layout.visibleItemsInfo.isNotEmpty()) list.scrollToItem(maxOf(0, index - 2))

            item.offset < layout.viewportStartOffset -> list.scrollToItem(index)

            item.offset + item.size > layout.viewportEndOffset ->
                list.scrollToItem(index, item.size - (layout.viewportEndOffset - layout.viewportStartOffset))
        }
    }
}

/** Keeps [list] at its top, if it is there, when [items] are added above, so that a new log is visible. */
@Composable
internal fun StayAtTop(list: LazyListState, items: List<Any>) {
    remember(items) {
        Snapshot.withoutReadObservation {
            if (list.firstVisibleItemIndex == 0 && list.firstVisibleItemScrollOffset == 0) list.requestScrollToItem(0)
        }
    }
}
