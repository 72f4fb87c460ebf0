"""What readers of binary files share: records that hold lists, and the numbers and faces in them."""
