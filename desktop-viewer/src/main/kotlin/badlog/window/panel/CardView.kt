package badlog.window.panel

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.panel.Card
import badlog.viewer.panel.Cards
import badlog.viewer.state.Action
import badlog.window.findings.findingColor
import badlog.window.findings.findingSoft
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText

/** Shows [cards] beside each other, or below each other in a narrow place. */
@Composable
internal fun CardsView(cards: Cards, send: (Action) -> Unit) {
    BoxWithConstraints(Modifier.fillMaxWidth()) {
        if (maxWidth < NARROW) {
            Column { for (card in cards.cards) CardView(card, send) }
        } else {
            Row { for (card in cards.cards) CardView(card, send, Modifier.weight(1f)) }
        }
    }
}

/** Shows [card] in a frame. */
@Composable
internal fun CardView(card: Card, send: (Action) -> Unit, modifier: Modifier = Modifier) {
    val palette = LocalPalette.current
    val color = card.severity?.let(palette::findingColor) ?: palette.text
    val press = card.open?.let { open -> Modifier.clickable(role = Role.Button, onClickLabel = card.hint) { send(open) } } ?: Modifier
    Column(
        modifier
            .padding(horizontal = 12.dp, vertical = 4.dp)
            .fillMaxWidth()
            .background(card.severity?.let(palette::findingSoft) ?: palette.raised, RoundedCornerShape(6.dp))
            .then(press)
            .padding(if (card.isLarge) 12.dp else 8.dp),
        Arrangement.spacedBy(if (card.isLarge) 8.dp else 2.dp),
    ) {
        if (card.title.isNotEmpty()) NameText(card.title, fontSize = SIZE, fontWeight = FontWeight.SemiBold, cut = NameCut.MIDDLE)
        val size = if (card.isLarge) SIZE * 2 else SIZE
        if (card.headline.isNotEmpty()) {
            Text(
                card.headline,
                color = color,
                fontSize = size,
                fontWeight = FontWeight.Bold,
                lineHeight = size * LINE,
                maxLines = 3,
                overflow = TextOverflow.Ellipsis,
            )
        }
        for (line in card.lines) Text(line, fontSize = SIZE, lineHeight = SIZE * LINE, maxLines = 3, overflow = TextOverflow.Ellipsis)
    }
}

private val SIZE = 14.sp
private const val LINE = 1.25
private val NARROW = 360.dp
