package badlog.viewer.topic

import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.SpanStyle
import androidx.compose.ui.text.buildAnnotatedString
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.text.withStyle
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import badlog.viewer.text.wordsOf
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.Palette

/** A folder of the list of topics. */
@Composable
internal fun FolderLine(row: FolderRow, query: String, onToggle: () -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier
            .fillMaxWidth()
            .clickable(onClick = onToggle)
            .semantics { contentDescription = "Folder ${row.path}" }
            .padding(start = indentOf(row.depth), end = 14.dp, top = 4.dp, bottom = 4.dp),
        horizontalArrangement = Arrangement.spacedBy(4.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Icon(if (row.isOpen) Icons.Down else Icons.Right, contentDescription = null, Modifier.size(14.dp), palette.muted)
        Text(
            withMatches(row.title, query, palette),
            Modifier.weight(1f),
            fontWeight = FontWeight.SemiBold,
            maxLines = 1,
            overflow = TextOverflow.Ellipsis,
        )
        Text(row.count.toString(), color = palette.muted, maxLines = 1)
    }
}

/** How far what lies in [depth] folders stands from the edge; deep ones keep room for their names. */
internal fun indentOf(depth: Int): Dp = (8 + 12 * minOf(depth, DEEPEST)).dp

/** [text] with what the words of [query] find in it marked. */
internal fun withMatches(text: String, query: String, palette: Palette): AnnotatedString = buildAnnotatedString {
    val isFound = BooleanArray(text.length)
    for (word in wordsOf(query)) {
        var at = text.indexOf(word, ignoreCase = true)
        while (at >= 0) {
            isFound.fill(true, at, at + word.length)
            at = text.indexOf(word, at + word.length, ignoreCase = true)
        }
    }
    text.forEachIndexed { index, char ->
        if (isFound[index]) withStyle(SpanStyle(palette.accent, background = palette.accentSoft)) { append(char) } else append(char)
    }
}

private const val DEEPEST = 6
