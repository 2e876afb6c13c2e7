package badlog.window.app

import androidx.compose.foundation.ExperimentalFoundationApi
import androidx.compose.foundation.draganddrop.dragAndDropTarget
import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.Modifier
import androidx.compose.ui.draganddrop.DragAndDropEvent
import androidx.compose.ui.draganddrop.DragAndDropTarget
import androidx.compose.ui.draganddrop.DragData
import androidx.compose.ui.draganddrop.dragData
import java.net.URI
import java.net.URISyntaxException
import java.nio.file.FileSystemNotFoundException
import java.nio.file.Path

/** Makes an element accept files and folders dropped from other programs, and passes them to [onDrop]. */
@OptIn(ExperimentalFoundationApi::class, ExperimentalComposeUiApi::class)
internal fun Modifier.acceptsFiles(onDrop: (List<Path>) -> Unit): Modifier = dragAndDropTarget(
    shouldStartDragAndDrop = { it.dragData() is DragData.FilesList },
    target = object : DragAndDropTarget {
        override fun onDrop(event: DragAndDropEvent): Boolean {
            val files = (event.dragData() as? DragData.FilesList)?.readFiles().orEmpty().mapNotNull(::pathOf)
            if (files.isNotEmpty()) onDrop(files)
            return files.isNotEmpty()
        }
    },
)

/** Returns the file that [uri] names, or null if it is not on this machine. */
internal fun pathOf(uri: String): Path? = try {
    Path.of(URI(uri))
} catch (_: URISyntaxException) {
    null
} catch (_: IllegalArgumentException) {
    null
} catch (_: FileSystemNotFoundException) {
    null
}
