package badlog.window.panel

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.viewer.panel.Field
import badlog.viewer.shown.search.Query
import badlog.viewer.state.Action
import badlog.window.menu.MenuBox
import badlog.window.menu.MenuLine
import badlog.window.theme.SearchField
import badlog.window.theme.ToolButton

/** Shows [field] as a search field, or as a button that opens its suggestions. */
@Composable
internal fun FieldView(field: Field, send: (Action) -> Unit) {
    if (field.isSearch) {
        SearchField(field.text, field.label, Modifier.fillMaxWidth().padding(horizontal = 8.dp, vertical = 4.dp)) { send(field.onText(it)) }
        return
    }
    var isOpen by remember { mutableStateOf(false) }
    val suggestions = @Composable {
        Suggestions(field.suggestions) { chosen ->
            isOpen = false
            send(field.onText(chosen))
        }
    }
    MenuBox(isOpen, { isOpen = false }, Modifier.padding(start = 22.dp), menu = suggestions) {
        ToolButton(field.hint, text = "${field.label} …") { isOpen = true }
    }
}

@Composable
private fun Suggestions(names: List<String>, onChosen: (String) -> Unit) {
    var filter by remember { mutableStateOf("") }
    val shown = remember(names, filter) { names.filter(Query(filter)::matches) }
    // A menu measures its content before it knows its size, which a lazy list needs to know.
    Column(Modifier.width(280.dp).padding(horizontal = 8.dp)) {
        SearchField(filter, "Search topics") { filter = it }
        LazyColumn(Modifier.width(264.dp).height(240.dp)) {
            items(shown) { name -> MenuLine(name) { onChosen(name) } }
        }
    }
}
