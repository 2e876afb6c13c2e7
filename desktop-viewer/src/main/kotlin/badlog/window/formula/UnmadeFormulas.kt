package badlog.window.formula

import androidx.compose.foundation.ContextMenuItem
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.choices.formula.Formula
import badlog.window.log.OpenRecording
import badlog.window.menu.ContextArea
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette

/** The formulas that do not work for [open], and the reasons; a click edits one. Empty if all work. */
@Composable
internal fun UnmadeFormulas(formulas: FormulaStore, open: OpenRecording) {
    val unmade = open.formulas.mapNotNull { formula -> reasonFor(formula, open)?.let { formula to it } }
    if (unmade.isEmpty()) return
    HorizontalDivider()
    Column(Modifier.fillMaxWidth().heightIn(max = 160.dp).verticalScroll(rememberScrollState())) {
        for ((formula, reason) in unmade) UnmadeLine(formulas, formula.definition, reason)
    }
}

/** Returns the reason why [formula] does not work for [open], as a sentence; null if it works. */
internal fun reasonFor(formula: Formula, open: OpenRecording): String? =
    formula.error?.message ?: "It has no samples here.".takeIf { formula.name?.let(open::signal) == null }

@Composable
private fun UnmadeLine(formulas: FormulaStore, definition: String, reason: String) {
    val palette = LocalPalette.current
    ContextArea({ formulaMenu(formulas, definition) }) {
        Row(
            Modifier
                .fillMaxWidth()
                .clickable { formulas.edit(definition) }
                .semantics { contentDescription = "Formula without a topic: $definition" }
                .padding(start = 8.dp, end = 12.dp, top = 4.dp, bottom = 4.dp),
            Arrangement.spacedBy(6.dp),
        ) {
            Icon(Icons.Formula, contentDescription = null, Modifier.padding(top = 2.dp).size(13.dp), palette.muted)
            Column(Modifier.weight(1f)) {
                Text(definition, color = palette.muted, maxLines = 1, overflow = TextOverflow.Ellipsis)
                Text(reason, color = palette.muted, fontSize = 11.sp, maxLines = 3, overflow = TextOverflow.Ellipsis)
            }
        }
    }
}

/** Returns the context menu of the formula [definition]. */
internal fun formulaMenu(formulas: FormulaStore, definition: String): List<ContextMenuItem> = listOf(
    ContextMenuItem("Change the formula…") { formulas.edit(definition) },
    ContextMenuItem("Remove the formula") { formulas.remove(definition) },
)
