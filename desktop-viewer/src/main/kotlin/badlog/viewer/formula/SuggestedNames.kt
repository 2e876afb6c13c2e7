package badlog.viewer.formula

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import badlog.viewer.theme.LocalPalette

/** The names that may be meant; the arrow keys and Tab choose as a click does. */
@Composable
internal fun SuggestedNames(writer: FormulaWriter) {
    val palette = LocalPalette.current
    Column(Modifier.fillMaxWidth().heightIn(max = 200.dp)) {
        writer.suggestions.names.forEachIndexed { index, name ->
            Text(
                name,
                Modifier
                    .fillMaxWidth()
                    .background(if (index == writer.marked) palette.accentSoft else Color.Transparent, RoundedCornerShape(4.dp))
                    .clickable { writer.take(index) }
                    .semantics {
                        contentDescription = "Insert $name"
                        selected = index == writer.marked
                    }
                    .padding(horizontal = 10.dp, vertical = 3.dp),
                maxLines = 1,
                overflow = TextOverflow.Ellipsis,
            )
        }
    }
}
