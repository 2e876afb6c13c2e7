package badlog.viewer.theme

import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.snapshots.Snapshot

/** Scrolls [list] as far as needed to show item [index], whenever another one is meant. */
@Composable
internal fun KeepInSight(list: LazyListState, index: Int) {
    LaunchedEffect(index) {
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

/** Leaves a list that stands at its top there when [items] come in above: a new log is not to appear out of sight. */
@Composable
internal fun StayAtTop(list: LazyListState, items: List<Any>) {
    remember(items) {
        Snapshot.withoutReadObservation {
            if (list.firstVisibleItemIndex == 0 && list.firstVisibleItemScrollOffset == 0) list.requestScrollToItem(0)
        }
    }
}
